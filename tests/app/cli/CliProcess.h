// The real dipwright-cli, run as a user's shell runs it.
#pragma once

#include <QByteArray>
#include <QStringList>

namespace dipwright::test {

struct Outcome {
    int exitCode = -1; // −1: it crashed
    QByteArray out, err;

    // The lines of standard error that begin with "error:".
    QList<QByteArray> errorLines() const;
};

QString cliPath();
// `environment`: "NAME=value" on top of this process's own.
Outcome cli(const QStringList& arguments, const QStringList& environment = {});
// Any other program, such as a shell that limits what the program may use.
Outcome program(const QString& path, const QStringList& arguments,
                const QStringList& environment = {});

} // namespace dipwright::test
