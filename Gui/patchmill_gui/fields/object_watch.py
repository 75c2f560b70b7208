"""FreeCAD's observer that tells when a document object goes, alone or with its document.

SPDX-License-Identifier: LGPL-2.1-or-later
"""

import weakref

import FreeCAD


class ObjectWatch:
    """FreeCAD's observer that calls `gone`, a method that it does not keep alive, when a document object
    goes, or its document."""

    def __init__(self, obj, gone):
        self.place, self.gone = (obj.Document.Name, obj.Name), weakref.WeakMethod(gone)

    def is_there(self):
        """Whether the object is in its document."""
        document = FreeCAD.listDocuments().get(self.place[0])
        return document is not None and document.getObject(self.place[1]) is not None

    def slotDeletedObject(self, obj):
        self._tell((obj.Document.Name, obj.Name) == self.place)

    def slotDeletedDocument(self, document):
        self._tell(document.Name == self.place[0])

    def _tell(self, mine):
        gone = self.gone()
        if mine and gone is not None:
            gone()
