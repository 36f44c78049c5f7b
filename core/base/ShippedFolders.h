// Where the files lie that come with the program. They are found from the program's own place, so
// that an installed tree runs from wherever it is put. None of the folders has to exist; the one of
// a build comes before the one of an installed tree.
#pragma once

#include <QString>
#include <QStringList>

namespace dipwright {

// Solver plugins: modules, and the descriptions beside them.
QStringList shippedPluginFolders();

// A program that only ours start; empty where there is none.
QString shippedProgram(const QString& name);
// That which reads foreign models and pictures.
QString readerProgram();

// Sample projects, *.dipw.
QStringList shippedSampleFolders();

} // namespace dipwright
