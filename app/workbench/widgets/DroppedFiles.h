// Which files are dropped on a window.
#pragma once

#include <QStringList>

class QMimeData;

namespace dipwright {

// Returns the paths of the local files. Web addresses are left out.
QStringList droppedFiles(const QMimeData& data);

} // namespace dipwright
