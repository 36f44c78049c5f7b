// Runs the test's own cluster: Slurm's controller and one node on this machine, with munge for
// authentication, in one temporary folder and on free ports. Changes nothing else on the machine.
// Everything ends with the object.
#pragma once

#include "CliProcess.h"

#include <QProcess>
#include <QTemporaryDir>

namespace dipwright::test {

class PrivateSlurm {
public:
    // Returns whether Slurm's programs are installed (Debian's slurm-wlm and munge).
    static bool isInstalled();

    // Starts the cluster, with two processors for jobs. If that fails, problem() says why.
    PrivateSlurm();
    ~PrivateSlurm();
    QString problem() const { return problem_; }

    // Runs one of Slurm's own commands: "sbatch", "scontrol", "squeue".
    Outcome command(const QString& name, const QStringList& arguments) const;
    // Submits a script. Returns its job number; empty if Slurm refuses it.
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
