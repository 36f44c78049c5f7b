// Saves a document and waits, as a test without a window does.
#pragma once

#include "workbench/document/Document.h"

namespace dipwright {

// Throws what DocumentSnapshot::write() throws.
inline void finishSave(Document& document, const DocumentSnapshot& snapshot) {
    try {
        document.endSave(snapshot, snapshot.write({}));
    } catch (...) {
        document.dropSave(snapshot);
        throw;
    }
}

inline void saveNow(Document& document) {
    finishSave(document, document.beginSave());
}

inline void saveNow(Document& document, const QString& path) {
    finishSave(document, document.beginSaveAs(path));
}

} // namespace dipwright
