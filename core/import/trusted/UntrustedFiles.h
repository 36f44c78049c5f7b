// Models and files from elsewhere, as they come to the readers and from them.
#pragma once

#include "model/TexturedMesh.h"

#include <QByteArray>
#include <QStringList>
#include <optional>

namespace dipwright {

// A model as read, neither welded nor repaired nor scaled: all triangles in the file's units, with
// corners that exist, the materials and pictures in use, and no charts.
struct UntrustedModel {
    TexturedMesh mesh;
    QStringList warnings; // what was left out, in sentences for the user
};

// Where a model that is read finds the other files that it names: materials, buffers, pictures.
// Whoever implements it decides what may be read; readers have no other way to a file. One thread.
class UntrustedFiles {
public:
    virtual ~UntrustedFiles() = default;

    // The whole content of the file of this name, as it stands in the model; nothing where there
    // is none. Throws Error where too many are asked for.
    std::optional<QByteArray> read(const QString& name);
    // Of all files so far.
    qint64 bytesRead() const { return bytesRead_; }

private:
    virtual std::optional<QByteArray> fetch(const QString& name) = 0;

    qint64 filesAskedFor_ = 0, bytesRead_ = 0;
};

} // namespace dipwright
