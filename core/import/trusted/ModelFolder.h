// Finds the files that a model names and decides which of them may be read. Private to this folder.
#pragma once

#include "import/trusted/UntrustedFiles.h"

#include <QDir>
#include <QStringList>

namespace dipwright {

// Finds files by the names in models: in quotes, with backslashes, percent codes, the wrong case,
// or a path on the computer where the model was made. A file belongs to the model's folder if its
// real location, after following links, is in there and not hidden. Other files are read only if
// allowed.
class ModelFolder : public UntrustedFiles {
public:
    ModelFolder(const QString& modelFile, bool allowOutside, const QStringList& allowedFiles);

    // Absolute paths of files that were requested but not read, because they are outside the
    // folder.
    const QStringList& outside() const { return outside_; }

private:
    std::optional<QByteArray> fetch(const QString& name) override;
    QString find(const QString& name);
    QString findRelative(const QString& path) const;
    bool isAllowed(const QString& file) const;

    QString modelFile_;
    QDir folder_;
    QString place_; // real path of the folder, after following links
    bool allowOutside_;
    QStringList allowedFiles_, outside_;
};

// Returns the whole content of a plain file; nothing if it cannot be read. Throws Error if it is
// larger than Budgets.h allows.
std::optional<QByteArray> readFile(const QString& path);

} // namespace dipwright
