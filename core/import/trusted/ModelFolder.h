// The files that a model file names, and which of them may be read. Private to this folder.
#pragma once

#include "import/trusted/UntrustedFiles.h"

#include <QDir>
#include <QStringList>

namespace dipwright {

// Finds files as models name them: with backslashes, percent codes or the wrong case, or by a path
// on the computer where the model was made. What is found belongs to the folder of the model where
// its real place, links followed, is in there and not hidden; of the rest is read what was allowed,
// all or some.
class ModelFolder : public UntrustedFiles {
public:
    ModelFolder(const QString& modelFile, bool allowOutside, const QStringList& allowedFiles);

    // Files that are there, were asked for and not read because they lie outside; absolute.
    const QStringList& outside() const { return outside_; }

private:
    std::optional<QByteArray> fetch(const QString& name) override;
    QString find(const QString& name);
    QString findRelative(const QString& path) const;
    bool isAllowed(const QString& file) const;

    QString modelFile_;
    QDir folder_;
    QString place_; // the folder's, links followed
    bool allowOutside_;
    QStringList allowedFiles_, outside_;
};

// The whole content of a plain file; nothing where it cannot be read. Throws Error where it is
// larger than Budgets.h allows.
std::optional<QByteArray> readFile(const QString& path);

} // namespace dipwright
