// Asks whether an export to a folder may replace files that the folder already contains.
#pragma once

#include <QStringList>

class QWidget;

namespace dipwright {

// Returns true if none of the `files` is in `folder`, or if the user allows to replace them.
// `title` names the export.
bool mayReplace(const QString& folder, const QStringList& files, const QString& title,
                QWidget* parent);

} // namespace dipwright
