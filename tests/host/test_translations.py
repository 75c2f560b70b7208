"""Translations: every text is found by lupdate and is in every catalogue, the compiled ones say what the
catalogues say, and no text is shown that was not to be translated.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import ast
import pathlib
import string
import sys
import unittest
import xml.etree.ElementTree as ElementTree
from unittest import mock

from _patchmill import InputError
from patchmill.machine import machine_table, machines
from patchmill.machine.schema import AXES, DIALECTS
from patchmill_gui.fields import known_sentences
from PySide import QtCore

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "Resources" / "translations"
sys.path.insert(0, str(ROOT / "tools"))

import sentence_texts  # noqa: E402
import table_texts  # noqa: E402

LANGUAGES = ("de", "ja")
MARKS = ("translate", "QT_TRANSLATE_NOOP")
SHOWN = (  # what is called with a text that the user reads
    *("QLabel", "QPushButton", "QCheckBox", "QGroupBox", "QAction", "wrapping_label", "addRow", "addItem"),
    *("setText", "setToolTip", "setWindowTitle", "setPlaceholderText", "setSpecialValueText"),
)
# texts from tables, which are marked where they are written or by tools/table_texts.py
FROM_TABLES = {
    ("dcm_colours.py", "title"),
    ("property_form.py", "title"),
    ("property_form.py", "label_of(name)"),
    ("property_form.py", "tip"),
    ("choice_rows.py", "choice"),
    ("texture_summary.py", "name"),
    ("known_sentences.py", "known"),
    ("machine_editor.py", "row.label"),
    ("machine_editor.py", "word"),
    ("texture_panel.py", "text"),
    ("texture_head.py", "patch.array"),
    ("property_table.py", "tip"),
    ("widgets.py", "text"),
}


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
            self.assertIn((file.name, ast.unparse(text)), FROM_TABLES, file)
        self.assertGreater(len(texts), 400)
        for language in LANGUAGES:
            missing = texts - set(catalogue(language))
            self.assertEqual(missing, set(), "run tools/translations")

    def test_the_texts_of_tables_are_up_to_date(self):
        written = table_texts.FILE.read_text(encoding="utf-8")
        self.assertEqual(written, table_texts.text_of_file(), "run tools/translations")

    def test_what_machine_files_may_say_is_translated_but_for_names(self):
        rows = [row for key in machines.names() for row in machine_table.rows(machines.load(key).data)]
        words = {word for row in rows for word in row.words} - {""} - set(DIALECTS) - set(AXES)
        self.assertEqual({word for word in words if len(word) > 1}, set(table_texts.MACHINE_WORDS))

    def test_no_text_is_shown_as_it_is_written(self):
        bare = []
        for file, call in calls(SHOWN, [f for f in files() if "Gui" in f.parts]):
            for argument in call.args[:1]:
                if isinstance(argument, ast.Constant) and isinstance(argument.value, str):
                    if any(letter.isalpha() for letter in argument.value):
                        bare.append("%s:%d %r" % (file.name, call.lineno, argument.value))
        self.assertEqual(bare, [])

    def test_sentences_of_errors_are_found_and_translated(self):
        """Nine in ten of them in each language: the others are met in macros, and where a shape is broken."""
        written = table_texts.SENTENCES.read_text(encoding="utf-8")
        self.assertEqual(written, table_texts.text_of_sentences(), "run tools/translations")
        sentences = written.splitlines()
        self.assertGreater(len(sentences), 400)
        for language in LANGUAGES:
            found = catalogue(language)
            done = [sentence for sentence in sentences if found["PatchMill", sentence] is not None]
            self.assertGreater(len(done), 0.9 * len(sentences))

    def test_sentences_are_found_as_sources_say_them(self):
        python = (
            'ONE = "give one."\ndef f(a):\n    remedy = "give %.3g mm or %s." % (1, "two")\n'
            '    if a:\n        raise InputError("A", "no " "face", remedy)\n'
            '    text = f"{a} is gone: " + "stop."\n'
            '    raise InputError("B", text, ONE if a else "give 100 %% of {} mm.".format(a))\n'
            'def g(made):\n    remedy = "this is of another function."\n'
            '    made.remarks.append("%d were left out." % 3)\n'
        )
        self.assertEqual(
            sorted(sentence_texts.of_python(python)),
            sorted(
                [
                    *("no face", "give {} mm or {}.", "{} is gone: stop.", "give one."),
                    *("give 100 % of {} mm.", "{} were left out."),
                ]
            ),
        )
        cpp = (
            'throw InputError("A", fmt::format("{:.3g} mm", f(1, 2)),\n'
            '  "give a (small) value, or "\n  "none.");'
            'throw InputError("B", "\'" + name + "\'", fmt::format("at most {}: give {} mm.", a[0], b));'
            'throw InputError("C", value, why + "Choose another.");'
        )
        self.assertEqual(
            [text for text in sentence_texts.of_cpp(cpp) if text.endswith(".")],
            ["give a (small) value, or none.", "at most {}: give {} mm.", "{}Choose another."],
        )

    def test_a_sentence_is_known_again_with_what_was_put_in(self):
        """In German: that of most words before one that leaves more open, an unknown one as it is."""
        translator = QtCore.QTranslator()
        self.assertTrue(translator.load(str(FOLDER / "PatchMill_de.qm")))
        with mock.patch.object(known_sentences.Qt, "translate", translator.translate):
            for sentence, german in (
                ("give 0.5 mm or more.", "0.5 mm oder mehr angeben."),
                ("give a value from 0.1 to 10 mm.", "Einen Wert von 0.1 bis 10 mm angeben."),
                ("plate.step: repair the shape.", "plate.step: Die Form in Ordnung bringen."),
                ("give one of: A, B.", "Eins davon angeben: A, B."),
                ("this is said nowhere.", "this is said nowhere."),
            ):
                self.assertEqual(known_sentences.translated(sentence), german)
            error = InputError("Spacing", "missing", "give 3 more than zero.")
            said = known_sentences.translated_error(error)
            self.assertEqual(said, "Abstand = fehlt: Für 3 mehr als null angeben.")

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
            labels = [text for context, text in table_texts.table_texts() if context == "PatchMill"]
            self.assertEqual([text for text in labels if found["PatchMill", text] is None], [])


if __name__ == "__main__":
    result = unittest.main(exit=False, verbosity=2, argv=["test"] + sys.argv[1:]).result
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
