// Defines how readers get untrusted files, and the form in which they return models.
#pragma once

#include "import/trusted/CadFacts.h"
#include "model/TexturedMesh.h"

#include <QByteArray>
#include <QStringList>
#include <optional>

namespace dipwright {

// A model as read: not welded, repaired or scaled. It has all triangles whose corners are valid, in
// the file's units. It has the materials and pictures that are used, and no charts.
struct UntrustedModel {
    TexturedMesh mesh;
    QStringList warnings;        // what was left out, in sentences for the user
    std::optional<CadFacts> cad; // of a CAD file, whose materials are its faces
};

// Gives readers the model file and the files that it names: materials, buffers, pictures. The
// implementation decides what may be read; readers have no other access to files. Use an object
// from one thread at a time.
class UntrustedFiles {
public:
    virtual ~UntrustedFiles() = default;

    // Returns the whole content of a file by its name in the model; nothing if there is none.
    // Throws Error if too many files are requested.
    std::optional<QByteArray> read(const QString& name);
    // Total size of all files read so far.
    qint64 bytesRead() const { return bytesRead_; }

private:
    virtual std::optional<QByteArray> fetch(const QString& name) = 0;

    qint64 filesAskedFor_ = 0, bytesRead_ = 0;
};

} // namespace dipwright
