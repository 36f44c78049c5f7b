#include "cli/Arguments.h"
#include "cli/Command.h"

#include "pipeline/DipCache.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/WriteResults.h"
#include "project/Project.h"
#include "project/ProjectStore.h"
#include "serving/JobServer.h"
#include "solver/SolverRegistry.h"

#include <QJsonArray>
#include <QThread>

namespace dipwright::cli {
namespace {

const QString listenOption = QStringLiteral("listen");
const QString tokenOption = QStringLiteral("token-file");
const QString bytesOption = QStringLiteral("most-mb");
const QString jobsOption = QStringLiteral("most-jobs");
constexpr qint64 mostDipBytes = qint64(1) << 30; // of one job

const QString minutesOption = QStringLiteral("most-minutes");

SpoolLimits limitsOf(const QCommandLineParser& parser) {
    constexpr int most = 100'000;
    SpoolLimits limits;
    limits.mostBytes = qint64(wholeNumberOption(parser, bytesOption, 1, most)) * 1'000'000;
    limits.mostJobs = wholeNumberOption(parser, jobsOption, 1, most);
    limits.mostSeconds = 60 * wholeNumberOption(parser, minutesOption, 1, most);
    return limits;
}

QJsonObject outcomeOf(const JobResult& result) {
    QJsonArray reasons;
    for (const JobReason& reason : reasonsOf(result)) {
        reasons.append(reasonText(reason, result, millimetres));
    }
    const SolverInfo& solver = result.solver;
    return {{"verdict", adviceKey(adviceOf(result))},
            {"reasons", reasons},
            {"solver", QJsonObject{{"id", solver.id},
                                   {"name", solver.name},
                                   {"version", solver.version},
                                   {"device", solver.device}}}};
}

// Runs one job like `run`. Also writes its dips, from which a window shows the result.
QJsonObject runJobOf(const SolverRegistry& registry, const QString& path, const QString& folder,
                     const Progress& progress) {
    JobOptions options;
    options.estimatesNumericalError = options.refines = true;
    const JobResult result =
        runAndWrite(loadProject(path), registry, options, nullptr, folder, progress);
    cacheDips(result, folder + QStringLiteral("/project.dipw"), mostDipBytes);
    return outcomeOf(result);
}

class ServeCommand : public Command {
public:
    QString name() const override { return QStringLiteral("serve"); }
    QString summary() const override {
        return QStringLiteral("Runs the jobs that other programs and machines send.");
    }

    void declare(CommandSyntax& syntax) const override {
        syntax.addPositionalArgument(
            QStringLiteral("FOLDER"),
            QStringLiteral("The folder for jobs and results. They stay when the server ends."));
        syntax.addOption({listenOption,
                          QStringLiteral("Where to listen: the path of a Unix socket, which only "
                                         "you may use, or a port of this computer, such as 8137. "
                                         "Use an SSH tunnel from other computers."),
                          QStringLiteral("ADDRESS")});
        syntax.addOption({tokenOption,
                          QStringLiteral("The file with the token that clients must send. It is "
                                         "made if it is missing. Default: FOLDER/token."),
                          QStringLiteral("FILE")});
        syntax.addOption({bytesOption, QStringLiteral("The largest project, in megabytes."),
                          QStringLiteral("N"), QStringLiteral("500")});
        syntax.addOption({jobsOption,
                          QStringLiteral("The most jobs in the folder, finished ones too."),
                          QStringLiteral("N"), QStringLiteral("100")});
        syntax.addOption({minutesOption, QStringLiteral("The longest run of one job, in minutes."),
                          QStringLiteral("N"), QStringLiteral("60")});
        declareThreads(syntax);
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        if (!parser.isSet(listenOption)) {
            throw UsageError(QStringLiteral("Name a Unix socket or a port with --listen ADDRESS"),
                             QStringLiteral("--listen"));
        }
        const ServerAddress address = asUsage(
            QStringLiteral("--listen"), [&] { return serverAddress(parser.value(listenOption)); });
        const QString folder = positionalArgument(parser, QStringLiteral("FOLDER"));
        const SpoolLimits limits = limitsOf(parser);
        const ThreadLimit threads = threadLimit(parser);
        const CancelToken user = console.progress().cancelToken;
        const SolverRegistry registry;
        JobSpool spool(
            folder, limits,
            [&](const QString& project, const QString& results, const Progress& progress) {
                return runJobOf(registry, project, results, progress);
            });
        const QString tokenFile = parser.isSet(tokenOption) ? parser.value(tokenOption)
                                                            : folder + QStringLiteral("/token");
        const JobServer server(address, tokenIn(tokenFile), spool, solverOfProject);
        console.out() << QStringLiteral("Listening on %1\nThe token is in %2\n")
                             .arg(address.text(), tokenFile);
        console.out().flush();
        constexpr unsigned long step = 100; // ms
        while (!user.isCancelled()) {
            QThread::msleep(step);
        }
        spool.stop(); // at once; the server still waits for its connections
    }
};

} // namespace

std::unique_ptr<Command> serveCommand() {
    return std::make_unique<ServeCommand>();
}

} // namespace dipwright::cli
