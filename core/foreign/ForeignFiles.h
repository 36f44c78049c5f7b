// Where a model that is read finds the other files that it names: materials, buffers, pictures.
#pragma once

#include <QByteArray>
#include <QString>
#include <optional>

namespace dipwright {

// Whoever implements it decides what may be read; readers have no other way to a file. One thread.
class ForeignFiles {
public:
    virtual ~ForeignFiles() = default;

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
