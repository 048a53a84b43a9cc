"""validate_json.py SCHEMA FILE...: says where a file breaks the schema, of a .jsonl file where a line
does. Exit 77: no jsonschema here."""

import json
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def documents(path):
    if not path.endswith(".jsonl"):
        return [load(path)]
    with open(path, encoding="utf-8") as file:
        return [json.loads(line) for line in file]


schema = load(sys.argv[1])
validator = jsonschema.validators.validator_for(schema)
validator.check_schema(schema)
failed = False
for path in sys.argv[2:]:
    for document in documents(path):
        for error in validator(schema).iter_errors(document):
            print(f"{path}: {error.json_path}: {error.message[:300]}")
            failed = True
sys.exit(1 if failed else 0)
