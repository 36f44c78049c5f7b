// The files that a model file names: materials, buffers, pictures. Private to this folder.
#pragma once

#include <QByteArray>
#include <QDir>
#include <QString>
#include <optional>

namespace dipwright {

// Finds files as models name them: with backslashes, percent codes or the wrong case, or by a path
// on the computer where the model was made.
class ModelFolder {
public:
    explicit ModelFolder(const QString& modelFile);

    // The path of an existing file, or empty.
    QString find(const QString& name) const;

private:
    QString findRelative(const QString& path) const;
    QDir folder_;
};

// The whole content; nothing where the file cannot be read.
std::optional<QByteArray> readFile(const QString& path);

} // namespace dipwright
