// Finds the files that are installed with the program. The functions search relative to the
// program's own path, so that an installed tree can be moved. The folders may be missing. Folders
// of a build come before folders of an installed tree.
#pragma once

#include <QString>
#include <QStringList>

namespace dipwright {

// Returns the folders with solver plugins (modules and their description files).
QStringList shippedPluginFolders();

// Returns the path of a helper program that only Dipwright's programs start; empty if it is
// missing.
QString shippedProgram(const QString& name);
// Returns the path of the sandboxed reader for models and pictures from untrusted sources.
QString readerProgram();
// Returns the path of the sandboxed reader for CAD files; empty if this program was built without
// it.
QString cadReaderProgram();

// If the system has no fonts, lets fontconfig use the fonts that the tarball ships. Must be called
// before the application object is created.
void useShippedFonts();

// For a library that another program loads (ProgramFolder.h): lets Qt use the plugins that the
// tarball ships. A program finds them by its qt.conf. Must be called before the application object
// is created.
void useShippedQtPlugins();

// Returns the folders with sample projects, *.dipw.
QStringList shippedSampleFolders();

} // namespace dipwright
