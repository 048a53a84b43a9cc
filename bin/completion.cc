// brachium completion: a script by which bash completes commands, flags and names. It asks the
// program itself for help, so it knows what the program knows, the flags of a chosen method too.
#include <iostream>

#include "bin/commands.h"
#include "bin/help.h"

namespace brachium {
namespace {

const CommandHelp kHelp = {
    "",
    "Prints a script by which bash completes commands, flags and the names of methods, "
    "scenarios and formats: source <(brachium completion)."};

constexpr const char* kScript = R"bash(# brachium: completion for bash.

# The next words of commands that begin with the words given.
_brachium_commands() {
  "$1" help 2>/dev/null | awk -v given="${*:2}" '
    /^$/ { on = 0 }
    on {
      sub(/^  /, ""); sub(/  .*/, "")
      if (given == "") print $1
      else if (index($0, given " ") == 1) { print $(split(given, words, " ") + 1) }
    }
    /^commands:/ { on = 1 }' | sort -u
}

# Help in, flags out: --NAME=, or --NAME where none or true or false may follow.
_brachium_flags() {
  awk '/^  --/ {
    sub(/=.*/, "=", $1)
    print $1 ($0 ~ /  \((number|whole number|text)/ ? "=" : "")
  }'
}

# Help in, the values that flag $1 may take out: those under the heading of its name.
_brachium_values() {
  awk -v stem="${1%s}" -v flag="--$1" '
    $1 == flag && /\(true or false/ { print "true"; print "false" }
    /^$/ { on = 0 }
    on && /^  [^ ]/ { print $1 }
    tolower($0) == stem "s:" { on = 1 }'
}

_brachium() {
  local program=${COMP_WORDS[0]} before word flag list command=() flags=()
  local line=${COMP_LINE:0:COMP_POINT}
  read -ra before <<<"$line"
  word=
  [[ $line == *[[:space:]] ]] || { word=${before[-1]}; unset 'before[-1]'; }
  for flag in "${before[@]:1}"; do
    if [[ $flag == -* || ${#flags[@]} -gt 0 ]]; then flags+=("$flag"); else command+=("$flag"); fi
  done

  COMPREPLY=()
  local commands=
  [ ${#flags[@]} -gt 0 ] || commands=$(_brachium_commands "$program" "${command[@]}")
  if [[ -n $commands ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$word")
    return
  fi
  local help
  help=$("$program" "${command[@]}" "${flags[@]}" --help 2>/dev/null) || return 0
  if [[ $word == --*=* ]]; then
    flag=${word%%=*} word=${word#*=} list=${word%"${word##*,}"}
    mapfile -t COMPREPLY < <(
      compgen -P "$list" -W "$(_brachium_values "${flag#--}" <<<"$help")" -- "${word##*,}")
  elif [[ -z $word || $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_brachium_flags <<<"$help")" -- "$word")
    [[ ${#COMPREPLY[@]} -ne 1 || ${COMPREPLY[0]} != *= ]] || compopt -o nospace 2>/dev/null
  fi
}

# Where nothing of this fits, a file's name does.
complete -o default -F _brachium brachium
)bash";

}  // namespace

int RunCompletion(CommandLine& line) {
  if (ShowHelp(line, kHelp)) return kGood;
  line.Read();
  std::cout << kScript;
  return kGood;
}

}  // namespace brachium
