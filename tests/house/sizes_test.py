"""No file of the repository has more than 350 lines, and no function more than 80. Left out are data and
pictures; and in scripts for browsers the function around a whole file, which keeps its names to itself."""

import ast
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).parents[2]
DATA = {".csv", ".h5", ".json", ".lock", ".msh", ".pdf", ".png", ".pyc", ".svg"}
LONGEST_FILE, LONGEST_FUNCTION = 350, 80
NO_FUNCTION = re.compile(r"\s*(namespace|struct|class|enum|union|template|using|extern|public|private|requires)\b")


def files():
    for path in sorted(ROOT.rglob("*")):
        parts = path.relative_to(ROOT).parts
        is_ours = parts[0] not in ("build", ".git", "LICENSE") and parts[:2] != ("tests", "data")
        if is_ours and path.is_file() and path.suffix not in DATA:
            yield path


def python_functions(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.name, node.end_lineno - node.lineno + 1


def braced_functions(text, starts, ends=("}",)):
    """Of text whose blocks are indented: from a line that begins what is in braces to the
    brace of the same indentation."""
    begun = {}
    for number, line in enumerate(text.splitlines()):
        indent = len(line) - len(line.lstrip())
        if line.strip() in ends and indent in begun:
            name, first = begun.pop(indent)
            yield name, number - first + 1
        elif starts(line) and indent <= 2:
            begun[indent] = line.strip(), number


def begins_in_cpp(line):
    return re.match(r"\s*[A-Za-z_~\[]", line) and not NO_FUNCTION.match(line)


def begins_in_javascript(line):
    return re.match(r"\s*(async )?function \w", line) or re.match(r"\s*(const|let) \w+ = .*(=>|function.*) \{$", line)


def begins_in_shell(line):
    return re.match(r"\w+\(\) \{$", line)


def functions(path):
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".py":
        return python_functions(text)
    if path.suffix in (".cpp", ".hpp"):
        return braced_functions(text, begins_in_cpp)
    if path.suffix == ".sh":
        return braced_functions(text, begins_in_shell)
    return braced_functions(text, begins_in_javascript, ("}", "};")) if path.suffix == ".js" else ()


class Sizes(unittest.TestCase):
    def test_files(self):
        long = {str(path.relative_to(ROOT)): len(path.read_text(encoding="utf-8").splitlines()) for path in files()}
        self.assertGreater(len(long), 1000)
        self.assertEqual({name: lines for name, lines in long.items() if lines > LONGEST_FILE}, {})

    def test_functions(self):
        found = [(path, name, lines) for path in files() for name, lines in functions(path)]
        self.assertGreater(len(found), 5000)
        long = [(str(path.relative_to(ROOT)), name, lines) for path, name, lines in found
                if lines > LONGEST_FUNCTION]
        self.assertEqual(long, [])

    def test_they_are_counted(self):
        two = "int one(\n    int a) {\n  return a;\n}\n\nstruct S {\n  void two() {\n    return;\n  }\n};\n"
        self.assertEqual([lines for _, lines in braced_functions(two, begins_in_cpp)], [4, 3])
        self.assertEqual(list(python_functions("def one():\n    a = 1\n    return a\n")), [("one", 3)])
        script = "  function one() {\n    return 1;\n  }\n"
        self.assertEqual([lines for _, lines in braced_functions(script, begins_in_javascript)], [3])


if __name__ == "__main__":
    unittest.main()
