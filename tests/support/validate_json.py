"""validate_json.py SCHEMA FILE...: says where a file breaks the schema. Exit 77: no jsonschema here."""

import json
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


schema = load(sys.argv[1])
validator = jsonschema.validators.validator_for(schema)
validator.check_schema(schema)
failed = False
for path in sys.argv[2:]:
    for error in validator(schema).iter_errors(load(path)):
        print(f"{path}: {error.json_path}: {error.message[:300]}")
        failed = True
sys.exit(1 if failed else 0)
