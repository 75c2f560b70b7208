"""Translations: every text is found by lupdate and is in every catalogue, the compiled ones say what the
catalogues say, and no text is shown that was not to be translated.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import ast
import pathlib
import re
import string
import sys
import unittest
import xml.etree.ElementTree as ElementTree

from PySide import QtCore

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "Resources" / "translations"
sys.path.insert(0, str(ROOT / "tools"))

import table_texts  # noqa: E402

SENTENCES = ROOT / "Gui" / "patchmill_gui" / "fields" / "known_sentences.py"
LANGUAGES = ("de", "ja")
MARKS = ("translate", "QT_TRANSLATE_NOOP")
SHOWN = (  # what is called with a text that the user reads
    *("QLabel", "QPushButton", "QCheckBox", "QGroupBox", "QAction", "wrapping_label", "addRow", "addItem"),
    *("setText", "setToolTip", "setWindowTitle", "setPlaceholderText", "setSpecialValueText"),
)
# texts from tables, which are marked where they are written or by tools/table_texts.py
FROM_TABLES = {
    ("property_form.py", "title"),
    ("property_form.py", "label_of(name)"),
    ("property_form.py", "tip"),
    ("choice_rows.py", "choice"),
    ("texture_summary.py", "name"),
    ("known_sentences.py", "known"),
    ("machine_editor.py", "row.label"),
    ("texture_panel.py", "text"),
    ("texture_head.py", "patch.array"),
    ("property_table.py", "tip"),
    ("widgets.py", "text"),
}
REMARKS = ("copy_panel.py", "remark")  # sentences of the package, which are not translated yet


def files():
    for folder in ("Gui/patchmill_gui", "src/patchmill"):
        yield from sorted((ROOT / folder).rglob("*.py"))


def name_of(call):
    return getattr(call.func, "id", getattr(call.func, "attr", ""))


def calls(names, where=None):
    for file in where or files():
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and name_of(node) in names:
                yield file, node


def catalogue(language):
    """{(context, text): translation or None}"""
    found = {}
    for context in ElementTree.parse(FOLDER / ("PatchMill_%s.ts" % language)).iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            done = translation.text if translation.get("type") is None else None
            found[context.findtext("name"), message.findtext("source")] = done
    return found


def fields(text):
    """What is to be put into a text: the formats of its {}, in any order."""
    return sorted(spec for _, name, spec, _ in string.Formatter().parse(text) if name is not None)


class Translations(unittest.TestCase):
    def test_every_text_is_in_every_catalogue(self):
        texts = set(table_texts.texts())
        for file, call in calls(MARKS):
            context, text = call.args
            if isinstance(text, ast.Constant) and isinstance(context, ast.Constant):
                texts.add((context.value, text.value))
                continue
            self.assertIn((file.name, ast.unparse(text)), FROM_TABLES | {REMARKS}, file)
        self.assertGreater(len(texts), 400)
        for language in LANGUAGES:
            missing = texts - set(catalogue(language))
            self.assertEqual(missing, set(), "run tools/translations")

    def test_the_texts_of_tables_are_up_to_date(self):
        written = table_texts.FILE.read_text(encoding="utf-8")
        self.assertEqual(written, table_texts.text_of_file(), "run tools/translations")

    def test_no_text_is_shown_as_it_is_written(self):
        bare = []
        for file, call in calls(SHOWN, [f for f in files() if "Gui" in f.parts]):
            for argument in call.args[:1]:
                if isinstance(argument, ast.Constant) and isinstance(argument.value, str):
                    if any(letter.isalpha() for letter in argument.value):
                        bare.append("%s:%d %r" % (file.name, call.lineno, argument.value))
        self.assertEqual(bare, [])

    def test_known_sentences_are_said_somewhere_and_are_translated(self):
        """Each is in a source as it stands, but for its numbers and where its lines are broken."""
        ours = [file for file in files() if file.name != "known_sentences.py"]
        sources = [*ours, *(ROOT / "src").rglob("*.cpp")]
        text = "\n".join(re.sub(r'"\s*f?"', "", file.read_text(encoding="utf-8")) for file in sources)
        (assigned,) = [
            node.value
            for node in ast.walk(ast.parse(SENTENCES.read_text(encoding="utf-8")))
            if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "SENTENCES"
        ]
        known = [call.args[1].value for call in assigned.elts]
        self.assertGreater(len(known), 35)
        for sentence in known:
            parts = [re.escape(part) for part in re.split(r"\{\}| mm\.$| degrees\.$", sentence)]
            self.assertRegex(text, "[^\"\n]{0,30}?".join(parts))
            for language in LANGUAGES:
                self.assertIsNotNone(catalogue(language)["PatchMill", sentence], sentence)

    def test_the_compiled_catalogues_say_the_same(self):
        for language in LANGUAGES:
            translator = QtCore.QTranslator()
            self.assertTrue(translator.load(str(FOLDER / ("PatchMill_%s.qm" % language))))
            done = {place: text for place, text in catalogue(language).items() if text is not None}
            for (context, source), text in done.items():
                self.assertEqual(translator.translate(context, source), text)
            self.assertGreater(len(done), 400)

    def test_what_is_put_into_a_text_is_put_into_its_translation(self):
        for language in LANGUAGES:
            for (_, source), text in catalogue(language).items():
                if text is not None:
                    self.assertEqual(fields(text), fields(source), text)
                    self.assertEqual(text.count("%"), source.count("%"), text)
                    self.assertEqual(
                        (text[:1] == " ", text[-1:] == ":"), (source[:1] == " ", source[-1:] == ":")
                    )

    def test_the_labels_of_the_panels_are_all_translated(self):
        for language in LANGUAGES:
            found = catalogue(language)
            labels = [text for context, text in table_texts.texts() if context == "PatchMill"]
            self.assertEqual([text for text in labels if found["PatchMill", text] is None], [])


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2, argv=["test"] + sys.argv[1:]).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
