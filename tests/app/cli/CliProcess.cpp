#include "CliProcess.h"
#include "TestFolders.h"

#include <QProcess>

namespace dipwright::test {

QList<QByteArray> Outcome::errorLines() const {
    QList<QByteArray> lines = err.split('\n');
    lines.removeIf([](const QByteArray& line) { return !line.startsWith("error:"); });
    return lines;
}

QString cliPath() {
    return binaryFolder("/dipwright-cli");
}

Outcome cli(const QStringList& arguments, const QStringList& environment) {
    return program(cliPath(), arguments, environment);
}

Outcome program(const QString& path, const QStringList& arguments, const QStringList& environment) {
    QProcess process;
    process.setProcessEnvironment([&] {
        QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
        // Removes the display, as on a machine without one.
        all.remove(QStringLiteral("DISPLAY"));
        all.remove(QStringLiteral("QT_QPA_PLATFORM"));
        for (const QString& variable : environment) {
            all.insert(variable.section(QLatin1Char('='), 0, 0),
                       variable.section(QLatin1Char('='), 1));
        }
        return all;
    }());
    process.start(path, arguments);
    process.waitForFinished(-1);
    const bool exited =
        process.exitStatus() == QProcess::NormalExit && process.error() == QProcess::UnknownError;
    return {exited ? process.exitCode() : -1, process.readAllStandardOutput(),
            process.readAllStandardError()};
}

} // namespace dipwright::test
