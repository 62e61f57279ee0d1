#include "comparisons/command_line/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace springcheck {
namespace {

using Words = std::vector<std::string>;

std::string joined(const Words& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

Words names_of(std::span<const CommandText> commands) {
  Words names;
  for (const CommandText& command : commands) names.push_back(command.name);
  return names;
}

/// All names of the command's options.
Words options_of(const CommandText& command) {
  Words names;
  for (const OptionText& option : command.options)
    if (!option.is_positional)
      names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

/// What completes a value.
struct Values {
  std::string type;
  Words words;
};

Values values_of(const OptionText& option) {
  return {option.type, option.words};
}

/// The types and words of the command's positional values, one after the other; with
/// `is_first_given` of those that may stand behind the first.
Values positional_values(const CommandText& command, bool is_first_given) {
  Values values;
  bool is_first = true;
  for (const OptionText& option : command.options) {
    if (!option.is_positional) continue;
    const bool is_given = is_first && is_first_given && !option.may_be_repeated;
    is_first = false;
    if (is_given) continue;
    values.type += (values.type.empty() ? "" : "|") + option.type;
    values.words.insert(values.words.end(), option.words.begin(), option.words.end());
  }
  return values;
}

/// The first clause, as people read it beside a name.
std::string short_text(const std::string& description) {
  const std::size_t end = std::min(
      {description.find(';'), description.find(". "), description.find(" (default")});
  return description.substr(0, end);
}

/// The text with a backslash before each of the characters.
std::string escaped(std::string_view text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'')
      result += "'\\''";
    else
      result += c;
  }
  return result + "'";
}

/// The values as bash sets them: `values='...'; files=-f`.
std::string bash_values(const Values& values) {
  std::string text = fmt::format("values={}", in_quotes(joined(values.words)));
  if (takes_files(values.type)) text += "; files=-f";
  if (takes_folders(values.type)) text += "; files=-d";
  return text;
}

/// The cases of options that have a value, or several.
std::string bash_cases(const CommandText& command, bool several) {
  std::string text;
  for (const OptionText& option : command.options)
    if (!option.is_positional && !option.type.empty() &&
        (!several || option.may_be_repeated))
      text += fmt::format("        {}) {} ;;\n", fmt::join(option.names, "|"),
                          bash_values(values_of(option)));
  return text;
}

std::string bash_case(const CommandText& command) {
  const std::string otherwise =
      fmt::format("if [ -n \"$placed\" ]; then {}; else {}; fi",
                  bash_values(positional_values(command, true)),
                  bash_values(positional_values(command, false)));
  const std::string of_several = bash_cases(command, true);
  std::string text =
      fmt::format("    {})\n      options={}\n      case $previous in\n{}", command.name,
                  in_quotes(joined(options_of(command))), bash_cases(command, false));
  if (of_several.empty())
    return text + fmt::format("        *) {} ;;\n      esac ;;\n", otherwise);
  return text + fmt::format(
                    "        *) case $option in\n{}        *) {} ;;\n"
                    "        esac ;;\n      esac ;;\n",
                    of_several, otherwise);
}

// Bash takes : and = for words of their own.
std::string bash_script(std::span<const CommandText> commands) {
  std::string cases;
  for (const CommandText& command : commands) cases += bash_case(command);
  return fmt::format(R"(# bash completion of springcheck; see springcheck help completion
_springcheck() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}}
  local values= options= files= before= option= placed= first=1 i
  COMPREPLY=()
  while [ "${{COMP_WORDS[first]}}" = --verbose ] && [ "$first" -lt "$COMP_CWORD" ]; do
    first=$((first + 1))
  done
  if [ "$COMP_CWORD" -eq "$first" ]; then
    mapfile -t COMPREPLY < <(compgen -W '{} --help --version --verbose' -- "$current")
    return
  fi
  # Whether the word behind the command is its first value.
  [ "$COMP_CWORD" -gt $((first + 1)) ] && case ${{COMP_WORDS[first+1]}} in -*) ;; *) placed=1 ;; esac
  for ((i = COMP_CWORD - 1; i > first; i--)); do
    case ${{COMP_WORDS[i]}} in -*) option=${{COMP_WORDS[i]}}; break ;; esac
  done
  local behind_option=$((i + 1)) replaced=
  if [ "$current" = = ]; then
    current=
  elif [ "$previous" = = ]; then
    previous=$option
  elif [ "$current" = : ] || [ "$previous" = : ]; then
    previous=$option current=
    for ((i = behind_option; i <= COMP_CWORD; i++)); do
      current+=${{COMP_WORDS[i]}}
    done
    current=${{current#=}}
    replaced=${{current%"${{current##*:}}"}}
  fi
  case ${{COMP_WORDS[first]}} in
{}  esac
  case $current in
    -*) values=$options files= ;;
    *,*) before=${{current%,*}}, ;;
  esac
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$values" -- "${{current##*,}}")
  COMPREPLY=("${{COMPREPLY[@]#"$replaced"}}")
  if [ -n "$files" ]; then
    compopt -o filenames
    mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen $files -- "$current")
  fi
}}
complete -F _springcheck springcheck
)",
                     joined(names_of(commands)), cases);
}

/// What zsh completes a value by: `:NAME:ACTION` of its _arguments.
std::string zsh_action(const Values& values) {
  const auto& [type, words] = values;
  const std::string name = escaped(type, ":[]");
  const char* const files = takes_folders(type) ? "_files -/" : "_files";
  const bool has_files = takes_files(type) || takes_folders(type);
  if (words.empty()) return fmt::format(":{}:{}", name, has_files ? files : "");
  if (has_files)
    return fmt::format(":{}: _alternative 'names:name:({})' 'files:file:{}'", name,
                       escaped(joined(words), ":"), files);
  return fmt::format(":{}: _sequence compadd - {}", name, escaped(joined(words), ":"));
}

std::string zsh_case(const CommandText& command) {
  std::string text = fmt::format("    {})\n      _arguments", command.name);
  int place = 0;
  for (const OptionText& option : command.options) {
    if (option.is_positional) {
      const std::string which = option.may_be_repeated ? "*" : fmt::to_string(++place);
      text += " \\\n        " + in_quotes(which + zsh_action(values_of(option)));
      continue;
    }
    const std::string description = escaped(short_text(option.description), ":[]");
    for (const std::string& name : option.names)
      text += " \\\n        " +
              in_quotes(
                  fmt::format("{}{}{}[{}]{}", option.may_be_repeated ? "*" : "", name,
                              option.type.empty() ? "" : "=", description,
                              option.type.empty() ? "" : zsh_action(values_of(option))));
  }
  return text + " ;;\n";
}

std::string zsh_script(std::span<const CommandText> commands) {
  std::string names, cases;
  for (const CommandText& command : commands) {
    names += fmt::format("    {}\n",
                         in_quotes(command.name + ":" + escaped(command.summary, ":")));
    cases += zsh_case(command);
  }
  return fmt::format(R"(#compdef springcheck
# zsh completion of springcheck; see springcheck help completion
_springcheck() {{
  local -a commands=(
{}  )
  while (( CURRENT > 2 )) && [ "$words[2]" = --verbose ]; do
    words[2]=()
    (( CURRENT-- ))
  done
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  shift words
  (( CURRENT-- ))
  case $words[1] in
{}  esac
}}
if [ "$funcstack[1]" = _springcheck ]; then
  _springcheck "$@"
else
  compdef _springcheck springcheck
fi
)",
                     names, cases);
}

/// The values of an option, or of what has no option's name, for fish's `complete`.
std::string fish_values(const Values& values, bool is_option) {
  const auto& [type, words] = values;
  std::string flags;
  if (takes_files(type))
    flags = is_option ? " -r -F" : " -F";
  else
    flags = is_option ? " -x" : " -f";
  if (takes_folders(type)) flags += " -a '(__fish_complete_directories)'";
  if (words.empty()) return flags;
  if (takes_files(type)) return flags + fmt::format(" -a {}", in_quotes(joined(words)));
  return flags + fmt::format(" -a {}", in_quotes(fmt::format("(__fish_append , {})",
                                                             joined(words))));
}

std::string fish_lines(const CommandText& command) {
  const std::string of_command =
      fmt::format("complete -c springcheck -n '__springcheck_has {}'", command.name);
  std::string lines =
      fmt::format("complete -c springcheck -n __springcheck_has -f -a {} -d {}\n",
                  command.name, in_quotes(command.summary));
  for (const bool is_first_given : {false, true}) {
    const Values values = positional_values(command, is_first_given);
    lines += fmt::format(
        "complete -c springcheck -n '__springcheck_has {}; and "
        "{}__springcheck_placed'{}\n",
        command.name, is_first_given ? "" : "not ",
        values.type.empty() ? " -f" : fish_values(values, false));
  }
  for (const OptionText& option : command.options) {
    if (option.is_positional) continue;
    lines += of_command;
    for (const std::string& name : option.names)
      lines += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    lines += " -d " + in_quotes(short_text(option.description));
    lines += option.type.empty() ? " -f" : fish_values(values_of(option), true);
    lines += "\n";
  }
  return lines;
}

std::string fish_script(std::span<const CommandText> commands) {
  std::string script =
      R"(# fish completion of springcheck; see springcheck help completion
function __springcheck_has # the command of that name, or none
  set -l words (commandline -opc) ''
  while test "$words[2]" = --verbose
    set -e words[2]
  end
  test "$words[2]" = "$argv"
end
function __springcheck_placed # whether the word behind the command is its first value
  set -l words (commandline -opc)
  while test "$words[2]" = --verbose
    set -e words[2]
  end
  set -q words[3]; and not string match -q -- '-*' $words[3]
end
)"
      "complete -c springcheck -n __springcheck_has -f\n"
      "complete -c springcheck -n __springcheck_has -l version -d 'print the "
      "version'\n"
      "complete -c springcheck -n __springcheck_has -l help -d 'print what there "
      "is'\n"
      "complete -c springcheck -n __springcheck_has -l verbose -d 'log every Newton "
      "iteration'\n";
  for (const CommandText& command : commands) script += fish_lines(command);
  return script;
}

}  // namespace

std::string completion_script(Shell shell, std::span<const CommandText> commands) {
  switch (shell) {
    case Shell::bash:
      return bash_script(commands);
    case Shell::zsh:
      return zsh_script(commands);
    case Shell::fish:
      return fish_script(commands);
  }
  throw std::logic_error("a shell that is none");
}

}  // namespace springcheck
