// Finds the files that are installed with the program. They are searched relative to the program,
// so that an installed tree can be moved. None of the folders has to exist. The build's folder
// comes before the installed tree's folder.
#pragma once

#include <QString>
#include <QStringList>

namespace dipwright {

// Folders with solver plugins (modules and their description files).
QStringList shippedPluginFolders();

// Path of a helper program that only these programs start; empty if it is missing.
QString shippedProgram(const QString& name);
// Path of the sandboxed reader for foreign models and pictures.
QString readerProgram();

// Folders with sample projects, *.dipw.
QStringList shippedSampleFolders();

} // namespace dipwright
