// Reads the repository's files for the tests of tests/house.
#pragma once

#include <QDir>
#include <QStringList>

// The root folder of the repository.
QDir sourceTree();

// Returns the text of a file, or an empty text if there is no such file. All paths are relative to
// the repository.
QString textOf(const QString& file);

// Returns the files in and below a folder whose names match a pattern, sorted.
QStringList filesIn(const QString& folder, const QStringList& patterns);

// Fails the test and prints the offences, one per line. An empty list passes.
void expectNone(const QStringList& offences);
