// Runs a separate cluster for the test: Slurm's controller and one node on this machine, with munge
// for authentication. It uses one temporary folder and free ports, and changes nothing else on the
// machine. All processes end when the object is destroyed.
#pragma once

#include "CliProcess.h"

#include <QProcess>
#include <QTemporaryDir>

namespace dipwright::test {

class PrivateSlurm {
public:
    // Returns whether Slurm's programs are installed (Debian's slurm-wlm and munge).
    static bool isInstalled();

    // Starts the cluster, with two processors for jobs. If that fails, problem() returns the
    // reason.
    PrivateSlurm();
    ~PrivateSlurm();
    QString problem() const { return problem_; }

    // Runs one of Slurm's own commands, for example "sbatch", "scontrol" or "squeue".
    Outcome command(const QString& name, const QStringList& arguments) const;
    // Submits a script. Returns its job number; empty if Slurm refuses it.
    QString submit(const QString& script, const QStringList& options = {}) const;
    // `state`: for example "RUNNING".
    bool isInState(const QString& job, const QByteArray& state) const;
    bool isEmpty() const; // whether no job runs or waits

private:
    QString path(const QString& name) const { return folder_.filePath(name); }
    bool write(const QString& name, const QByteArray& text) const;
    bool start(QProcess& process, const QString& name, const QStringList& arguments);

    QTemporaryDir folder_;
    QProcess munge_, controller_, node_;
    QString problem_;
};

} // namespace dipwright::test
