#include "PrivateSlurm.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QStandardPaths>
#include <QSysInfo>
#include <QTest>

#include <array>
#include <netinet/in.h>
#include <pwd.h>
#include <sys/socket.h>
#include <unistd.h>

namespace dipwright::test {
namespace {

constexpr int longestStart = 60'000, longestEnd = 20'000; // ms

// Also finds daemons, which are not in every user's path.
QString programPath(const QString& name) {
    const QString found = QStandardPaths::findExecutable(name);
    return found.isEmpty() ? QStandardPaths::findExecutable(
                                 name, {QStringLiteral("/usr/sbin"), QStringLiteral("/sbin")})
                           : found;
}

// Returns two ports on which nobody listens.
std::array<int, 2> freePorts() {
    std::array<int, 2> ports{}, sockets{};
    for (std::size_t number = 0; number < ports.size(); ++number) {
        sockets[number] = socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof(address);
        if (bind(sockets[number], reinterpret_cast<sockaddr*>(&address), size) == 0 &&
            getsockname(sockets[number], reinterpret_cast<sockaddr*>(&address), &size) == 0) {
            ports[number] = ntohs(address.sin_port);
        }
    }
    for (const int socket : sockets) { // all sockets are closed together, so that the ports differ
        close(socket);
    }
    return ports;
}

// A requeued job waits until its old credential expires. Here this takes 5 seconds instead of
// minutes.
constexpr char configuration[] = R"(ClusterName=test
SlurmctldHost=HOST(127.0.0.1)
SlurmctldPort=PORT1
SlurmdPort=PORT2
AuthType=auth/munge
AuthInfo=socket=FOLDER/munge.socket,cred_expire=5
CredType=cred/munge
SlurmUser=USER
SlurmdUser=USER
StateSaveLocation=FOLDER/state
SlurmdSpoolDir=FOLDER/spool
SlurmctldPidFile=FOLDER/controller.pid
SlurmdPidFile=FOLDER/node.pid
SlurmctldLogFile=FOLDER/controller.log
SlurmdLogFile=FOLDER/node.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,batch_sched_delay=0
KillWait=1
ReturnToService=2
NodeName=test NodeAddr=127.0.0.1 NodeHostname=HOST CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
)";

} // namespace

bool PrivateSlurm::isInstalled() {
    for (const char* program : {"munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol"}) {
        if (programPath(QLatin1String(program)).isEmpty()) {
            return false;
        }
    }
    return true;
}

bool PrivateSlurm::write(const QString& name, const QByteArray& text) const {
    QFile file(path(name));
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() &&
           file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
}

bool PrivateSlurm::start(QProcess& process, const QString& name, const QStringList& arguments) {
    process.setStandardOutputFile(path(name + QStringLiteral(".out")));
    process.setStandardErrorFile(path(name + QStringLiteral(".err")));
    process.start(programPath(name), arguments);
    if (!process.waitForStarted()) {
        problem_ = QStringLiteral("%1 does not start: %2").arg(name, process.errorString());
        return false;
    }
    return true;
}

PrivateSlurm::PrivateSlurm() {
    const std::array<int, 2> ports = freePorts();
    QByteArray text = configuration;
    text.replace("HOST", QSysInfo::machineHostName().section(QLatin1Char('.'), 0, 0).toUtf8());
    text.replace("PORT1", QByteArray::number(ports[0]));
    text.replace("PORT2", QByteArray::number(ports[1]));
    text.replace("USER", getpwuid(geteuid())->pw_name);
    text.replace("FOLDER", folder_.path().toUtf8());
    QByteArray key(128, '\0'); // secret: anybody who knows it may run any program
    QRandomGenerator::system()->generate(key.begin(), key.end());
    // Munge requires that everybody can read the path to its socket.
    QFile::setPermissions(folder_.path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner |
                                              QFile::ReadGroup | QFile::ExeGroup |
                                              QFile::ReadOther | QFile::ExeOther);
    if (!write(QStringLiteral("slurm.conf"), text) || !write(QStringLiteral("munge.key"), key) ||
        !QDir().mkpath(path(QStringLiteral("state"))) ||
        !QDir().mkpath(path(QStringLiteral("spool")))) {
        problem_ = QStringLiteral("its files cannot be written");
        return;
    }
    const QString socket = path(QStringLiteral("munge.socket"));
    if (!start(munge_, QStringLiteral("munged"),
               {"--foreground", "--force", "--socket=" + socket,
                "--key-file=" + path(QStringLiteral("munge.key")),
                "--log-file=" + path(QStringLiteral("munge.log")),
                "--pid-file=" + path(QStringLiteral("munge.pid")),
                "--seed-file=" + path(QStringLiteral("munge.seed"))}) ||
        !QTest::qWaitFor([&] { return QFileInfo::exists(socket); }, longestStart)) {
        problem_ = QStringLiteral("munge does not answer");
        return;
    }
    const QString settings = path(QStringLiteral("slurm.conf"));
    if (!start(controller_, QStringLiteral("slurmctld"), {"-D", "-f", settings}) ||
        !start(node_, QStringLiteral("slurmd"), {"-D", "-f", settings, "-N", "test"})) {
        return;
    }
    const auto isIdle = [&] {
        return command(QStringLiteral("sinfo"), {"--noheader", "--format=%T"}).out.trimmed() ==
               "idle";
    };
    if (!QTest::qWaitFor(isIdle, longestStart)) {
        problem_ = QStringLiteral("the node does not come up");
    }
}

PrivateSlurm::~PrivateSlurm() {
    command(QStringLiteral("scancel"), {"--user", QString::fromUtf8(getpwuid(geteuid())->pw_name)});
    for (QProcess* process : {&node_, &controller_, &munge_}) {
        process->terminate();
        if (process->state() != QProcess::NotRunning && !process->waitForFinished(longestEnd)) {
            process->kill();
            process->waitForFinished();
        }
    }
}

Outcome PrivateSlurm::command(const QString& name, const QStringList& arguments) const {
    return program(programPath(name), arguments,
                   {QStringLiteral("SLURM_CONF=") + path(QStringLiteral("slurm.conf"))});
}

QString PrivateSlurm::submit(const QString& script, const QStringList& options) const {
    const Outcome submitted = command(QStringLiteral("sbatch"),
                                      QStringList{"--parsable"} + options + QStringList{script});
    return submitted.exitCode == 0 ? QString::fromUtf8(submitted.out.trimmed()) : QString();
}

bool PrivateSlurm::isInState(const QString& job, const QByteArray& state) const {
    return command(QStringLiteral("squeue"), {"--noheader", "--format=%T", "--jobs", job})
               .out.trimmed() == state;
}

bool PrivateSlurm::isEmpty() const {
    const Outcome all = command(QStringLiteral("squeue"), {"--noheader"});
    return all.exitCode == 0 && all.out.trimmed().isEmpty();
}

} // namespace dipwright::test
