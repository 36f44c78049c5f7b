// The repository's files, as the rules of the house read them.
#pragma once

#include <QDir>
#include <QStringList>

// Where the repository lies.
QDir sourceTree();

// What a file says; empty where there is none. FILE is relative to the repository, as all here.
QString textOf(const QString& file);

// The files in a folder and below it whose names fit, in order.
QStringList filesIn(const QString& folder, const QStringList& patterns);

// One a line: what breaks a rule. The test fails where there is any.
void expectNone(const QStringList& offences);
