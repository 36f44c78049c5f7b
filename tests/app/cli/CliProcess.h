// Runs the real dipwright-cli like a user's shell.
#pragma once

#include <QByteArray>
#include <QStringList>

namespace dipwright::test {

struct Outcome {
    int exitCode = -1; // −1: it crashed
    QByteArray out, err;

    // Returns the lines of standard error that begin with "error:".
    QList<QByteArray> errorLines() const;
};

QString cliPath();
// Runs dipwright-cli to its end. `environment`: entries "NAME=value", added to this process's own.
Outcome cli(const QStringList& arguments, const QStringList& environment = {});
// Runs any other program to its end, such as a shell that sets limits for dipwright-cli.
Outcome program(const QString& path, const QStringList& arguments,
                const QStringList& environment = {});

} // namespace dipwright::test
