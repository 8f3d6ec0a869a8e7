# SPDX-License-Identifier: MIT
"""The wrong calls of the program's table, made from Python: the same sentence, the same code, nothing lost."""
import ast
import shlex

from support import FolderCase, SOURCE, frostfill, unittest


def table():
    """Line, code, words, call and bytes of FILE of each call that Python can make."""
    for number, line in enumerate((SOURCE / "tests/support/wrong_calls.txt").read_text().splitlines(), 1):
        if line and not line.startswith("#"):
            code, says, call, text = (line + " ").split(" | ", 3)
            if not code.endswith("+"):
                content = text[:-1].encode().decode("unicode_escape").encode("latin-1")
                yield number, int(code), says, shlex.split(call), content


def value(word):
    """A number where it is one, as a caller would give it."""
    try:
        return float("nan") if word == "nan" else ast.literal_eval(word)
    except (ValueError, SyntaxError):
        return word


def keywords_of(words):
    keywords = {}
    name = ""
    for word in words:
        if name == "set":
            key, _, text = word.partition("=")
            keywords[key.replace(".", "_")] = {"true": True, "false": False}.get(text, value(text))
            name = ""
        elif word == "--set":
            name = "set"
        elif word.startswith("--"):
            name = word[2:].replace("-", "_")
            keywords[name] = True
        else:
            keywords[name] = word if name in ("sizes", "columns", "only", "frames", "to") else value(word)
    return keywords


class WrongCallTable(FolderCase):
    def setUp(self):
        super().setUp()
        self.run = frostfill.fill("cube", count=5, motion="descend", out=self.folder / "run")
        self.run.export(self.folder / "export", "csv")
        (self.folder / "folder").mkdir()

    def content(self):
        return {path: path.is_file() and path.read_bytes() for path in self.folder.rglob("*")}

    def make(self, command, what, keywords):
        path = self.folder / what
        if command == "fill":
            if "sizes" in keywords and (self.folder / keywords["sizes"]).exists() or ".csv" in keywords.get("sizes", ""):
                keywords["sizes"] = str(self.folder / keywords["sizes"])
            frostfill.fill(what, count=5, out=self.folder / "run", overwrite=True, **keywords)
        elif command == "export":
            out = self.folder / keywords.pop("out", "run/export")
            frostfill.load(path).export(out, keywords.pop("to"), **keywords)
        else:
            given = {}
            if "columns" in keywords:
                given["columns"] = dict(pair.split("=") for pair in keywords.pop("columns").split(","))
            packing = frostfill.read_packing(path, **given)
            {"check": frostfill.check, "analyse": frostfill.analyse}[command](packing.centres, packing.radii, **keywords)

    def test_ends_each_call_with_the_code_and_the_words_of_the_program(self):
        made = 0
        for number, code, says, words, content in table():
            (self.folder / "input.csv").write_bytes(content)
            before = self.content()
            command, what, *rest = [word.replace("FILE", "input.csv") for word in words]
            with self.subTest(line=number, call=words):
                with self.assertRaises(frostfill.Error) as caught:
                    self.make(command, what, keywords_of(rest))
                sentence = str(caught.exception)
                self.assertIn(says.lstrip("-").replace("-", "_") if says.startswith("--") else says,
                              sentence.replace("-", "_") if says.startswith("--") else sentence)
                self.assertEqual(caught.exception.code, code, sentence)
                self.assertNotIn("\n", sentence)
                self.assertEqual(self.content(), before)
            made += 1
        self.assertGreaterEqual(made, 100)


if __name__ == "__main__":
    unittest.main()
