// Turns the bytes of a CAD file into OpenCASCADE's document. Private to this folder.
#pragma once

#include <QByteArray>
#include <QString>

#include <TDocStd_Document.hxx>
#include <XSControl_WorkSession.hxx>

namespace dipwright {

struct CadDocument {
    Handle(TDocStd_Document) document; // lengths in mm
    Handle(XSControl_WorkSession) session;
    QString unit;           // of the file, as the file names it; empty: none
    bool isSewn = true;     // whether neighbouring faces share their edges
    int failedEntities = 0; // entities that could not be read, so faces or parts may be missing
};

// Throws Error if the bytes are neither STEP nor IGES, or damaged. `path` is for messages.
CadDocument cadDocument(const QByteArray& bytes, const QString& path);

// Throws Error with a sentence that says why the CAD file cannot be read.
[[noreturn]] void throwDamagedCad(const QString& reason, const QString& path);

} // namespace dipwright
