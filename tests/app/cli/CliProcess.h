// Runs the real dipwright-cli as a user's shell does.
#pragma once

#include <QByteArray>
#include <QStringList>

namespace dipwright::test {

struct Outcome {
    int exitCode = -1; // −1: the program crashed
    QByteArray out, err;

    // Returns the lines of standard error that begin with "error:".
    QList<QByteArray> errorLines() const;
};

QString cliPath();
// Runs dipwright-cli to its end. `environment` has entries "NAME=value", which are added to this
// process's environment.
Outcome cli(const QStringList& arguments, const QStringList& environment = {});
// Runs any other program to its end, for example a shell that sets limits for dipwright-cli.
Outcome program(const QString& path, const QStringList& arguments,
                const QStringList& environment = {});

} // namespace dipwright::test
