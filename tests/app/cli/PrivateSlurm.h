// A cluster of the test's own: Slurm's controller and one node on this machine, with munge, which
// tells them who asks, all in one temporary folder and on free ports. Nothing of the machine's is
// touched, and everything ends with the object.
#pragma once

#include "CliProcess.h"

#include <QProcess>
#include <QTemporaryDir>

namespace dipwright::test {

class PrivateSlurm {
public:
    // Whether its programs are installed (Debian's slurm-wlm and munge).
    static bool isInstalled();

    // Starts it, with two processors for jobs; problem() says what went wrong.
    PrivateSlurm();
    ~PrivateSlurm();
    QString problem() const { return problem_; }

    // One of Slurm's own commands: "sbatch", "scontrol", "squeue".
    Outcome command(const QString& name, const QStringList& arguments) const;
    // Submits a script and returns the number of its job; empty where that is refused.
    QString submit(const QString& script, const QStringList& options = {}) const;
    bool isInState(const QString& job, const QByteArray& state) const; // "RUNNING"
    bool isEmpty() const;                                              // nothing runs or waits

private:
    QString path(const QString& name) const { return folder_.filePath(name); }
    bool write(const QString& name, const QByteArray& text) const;
    bool start(QProcess& process, const QString& name, const QStringList& arguments);

    QTemporaryDir folder_;
    QProcess munge_, controller_, node_;
    QString problem_;
};

} // namespace dipwright::test
