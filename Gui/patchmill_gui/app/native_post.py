"""Says in the report view what is wrong with a program that FreeCAD's own Post command has just written. That
command tells nobody; but FreeCAD 0.20 notes the file in the job, and property changes are told.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import FreeCAD
from PySide import QtCore

NOTED = "LastPostProcessOutput"


class Observer:
    """Of all documents. FreeCAD calls its slots by their names."""

    def slotChangedObject(self, obj, name):
        if name == NOTED and "Restore" not in obj.State and hasattr(obj, "PostProcessorArgs"):
            place = obj.Document.Name, obj.Name
            QtCore.QTimer.singleShot(0, lambda: tell(*place))  # when the command has ended


def tell(document, name):
    """Says what there is to say of the program that a job, by its names, was posted to."""
    from patchmill.posting import native_post

    document = FreeCAD.listDocuments().get(document)
    job = document.getObject(name) if document else None
    if job is None or not getattr(job, NOTED) or not native_post.concerns(job):
        return
    for sentence in native_post.findings(job, getattr(job, NOTED)):
        FreeCAD.Console.PrintError(sentence)


def watch():
    FreeCAD.addDocumentObserver(Observer())
