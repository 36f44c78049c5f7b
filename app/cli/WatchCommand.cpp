#include "cli/Arguments.h"
#include "cli/HotFolder.h"
#include "cli/PrintOptions.h"
#include "cli/VerdictOutput.h"

#include "base/JsonText.h"
#include "disk/FolderTransaction.h"
#include "disk/SmallFile.h"
#include "pipeline/DipCache.h"
#include "pipeline/JobPacking.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/WriteResults.h"
#include "project/Project.h"
#include "solver/SolverRegistry.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QThread>

namespace dipwright::cli {
namespace {

const QString outOption = QStringLiteral("out");
const QString onceOption = QStringLiteral("once");
constexpr int mostCopies = 999;

// What is to be done with a project: the contents of a print ticket, or the default.
struct Order {
    QString project;      // path
    QString printer = {}; // empty: the one of the command line
    int copies = 1;
    std::optional<int> immersion = {}; // counted from 1; none: all
    std::vector<Setting> settings = {};
};

// Returns the value as text for --set: lists of numbers and words joined by ";", other lists as
// JSON.
QString settingText(const QJsonValue& value) {
    if (value.isArray()) {
        QStringList parts;
        for (const QJsonValue& part : value.toArray()) {
            if (part.isArray() || part.isObject()) {
                return QString::fromUtf8(
                    QJsonDocument(value.toArray()).toJson(QJsonDocument::Compact));
            }
            parts << settingText(part);
        }
        return parts.join(u';');
    }
    return value.isDouble() ? QString::number(value.toDouble(), 'g', 17)
           : value.isBool() ? QString(value.toBool() ? "true" : "false")
           : value.isNull() ? QStringLiteral("null")
                            : value.toString();
}

int wholeNumber(const QJsonValue& value, int most, const QString& key, const QString& path) {
    const int number = value.toInt(0);
    if (number < 1 || number > most) {
        throw Error(QStringLiteral("“%1” must be a whole number from 1 to %2").arg(key).arg(most),
                    path);
    }
    return number;
}

Order readTicket(const QString& path, const HotFolder& folder) {
    const QByteArray text = readSmallFile(path, mostTicketBytes);
    requireJsonWithinLimits(text, path);
    const QJsonObject ticket = QJsonDocument::fromJson(text).object();
    if (ticket[QStringLiteral("format")] != QLatin1String("dipwright-print-ticket") ||
        ticket[QStringLiteral("version")] != 1) {
        throw Error(QStringLiteral("This is no print ticket; it needs “format”: "
                                   "“dipwright-print-ticket” and “version”: 1"),
                    path);
    }
    Order order;
    for (auto entry = ticket.begin(); entry != ticket.end(); ++entry) {
        const QString key = entry.key();
        const QJsonValue value = entry.value();
        if (key == u"project") {
            order.project = folder.project(value.toString());
        } else if (key == u"printer" && value.isString()) {
            order.printer = value.toString();
        } else if (key == u"copies") {
            order.copies = wholeNumber(value, mostCopies, key, path);
        } else if (key == u"immersion") {
            order.immersion = wholeNumber(value, 2, key, path);
        } else if (key == u"set" && value.isObject()) {
            const QJsonObject settings = value.toObject();
            for (auto setting = settings.begin(); setting != settings.end(); ++setting) {
                order.settings.push_back({setting.key(), settingText(setting.value()), path});
            }
        } else if (key != u"format" && key != u"version") {
            throw Error(
                QStringLiteral("The ticket's entry “%1” is not known or not valid").arg(key), path);
        }
    }
    if (order.project.isEmpty()) {
        throw Error(QStringLiteral("The ticket names no “project”"), path);
    }
    return order;
}

// Thrown if a job must not be printed without the user.
class HeldError : public Error {
public:
    using Error::Error;
};

// Processes the jobs of one folder.
class Watch {
public:
    Watch(const QCommandLineParser& parser, Console& console)
        : parser_(parser), console_(console), out_(parser.value(outOption)),
          required_(requiredAdvice(parser)),
          folder_(positionalArgument(parser, QStringLiteral("FOLDER"))) {
        FolderTransaction(out_, {QStringLiteral("report.json")}); // fails now, not at the first job
    }

    // Throws Error if jobs failed, after all jobs.
    void processJobs() {
        const Progress progress = console_.progress();
        for (const QString& name : folder_.interrupted()) {
            console_.out()
                << QStringLiteral("%1: held: the program ended while it was printed\n").arg(name);
        }
        for (;;) {
            // The list is read anew for each job, because files change while a job runs.
            const std::vector<HotJob> jobs = folder_.completeJobs();
            if (!jobs.empty()) {
                process(jobs.front(), progress);
                console_.out().flush();
            } else if (parser_.isSet(onceOption) && !folder_.hasJobs()) {
                refuseFailures();
                return;
            } else if (!wait(progress.cancelToken)) {
                return;
            }
        }
    }

private:
    // Waits for a second. Returns false at once if the user ends the program.
    static bool wait(const CancelToken& user) {
        constexpr unsigned long step = 100; // milliseconds
        for (int i = 0; i < 10 && !user.isCancelled(); ++i) {
            QThread::msleep(step);
        }
        return !user.isCancelled();
    }

    void refuseFailures() const {
        if (failures_ > 0) {
            throw Error(QStringLiteral("Jobs that failed: %1. Correct them as the texts in the "
                                       "folders “failed” and “held” say")
                            .arg(failures_),
                        positionalArgument(parser_, QStringLiteral("FOLDER")));
        }
    }

    void process(const HotJob& job, const Progress& progress) {
        const QString name = QFileInfo(job.path).fileName();
        QString path = job.path; // where the job is now
        HotState state = HotState::Done;
        QString text;
        try {
            text = run(job, path, progress);
        } catch (const HeldError& error) {
            state = HotState::Held;
            text = error.message();
        } catch (const Error& error) {
            state = failed(path, job);
            text = error.sentence();
        } catch (const std::bad_alloc&) {
            state = failed(path, job);
            text = QStringLiteral("There is not enough memory for this job");
        }
        if (!QFileInfo::exists(path)) {
            console_.out() << QStringLiteral("%1: was removed from the folder\n").arg(name);
            return;
        }
        text += folder_.end(path, state, text);
        console_.out() << QStringLiteral("%1: %2\n")
                              .arg(name, state == HotState::Done ? QStringLiteral("done")
                                         : state == HotState::Failed
                                             ? QStringLiteral("failed: %1").arg(text)
                                             : QStringLiteral("held: %1").arg(text));
    }

    // Once printing has begun, it is not known which sheets came out.
    HotState failed(const QString& path, const HotJob& job) {
        ++failures_;
        return path == job.path ? HotState::Failed : HotState::Held;
    }

    // Runs and prints a job. Returns what was done. Changes `path` when the job is moved.
    QString run(const HotJob& job, QString& path, const Progress& progress) {
        const Order order = isTicket(path) ? readTicket(path, folder_) : Order{path};
        Project project = readProject(order.project, parser_);
        useProfile(parser_, project);
        applySettings(project, order.settings);
        const QString results = resultFolder(QFileInfo(path).completeBaseName());
        JobOptions options;
        options.estimatesNumericalError = options.refines = true;
        const auto kept =
            usableDips(project, registry_, order.project, progress.silent(), console_.warnings());
        const JobResult result =
            runAndWrite(project, registry_, options, kept.get(), results, progress.part(0, 0.8));
        QString text;
        QTextStream lines(&text);
        printVerdict(result, lines);
        lines << wrote(results);
        const QString printer = order.printer.isEmpty() ? printerName(parser_) : order.printer;
        if (!job.isReleased && required_ && isWorse(verdictToCompare(result), *required_)) {
            throw HeldError(text + QStringLiteral("The verdict is worse than required. To print "
                                                  "the job, move it to the folder “release”."),
                            path);
        }
        if (!printer.isEmpty()) {
            print(result, order, printer, path, progress.part(0.8, 1), lines);
        }
        lines.flush();
        return text.trimmed();
    }

    // Returns a folder with the job's name, and a number if there are results of an earlier job.
    QString resultFolder(const QString& job) const {
        QString folder = out_ + u'/' + job;
        for (int number = 2; QFileInfo::exists(folder + QStringLiteral("/report.json")); ++number) {
            folder = QStringLiteral("%1/%2-%3").arg(out_, job).arg(number);
        }
        return folder;
    }

    void print(const JobResult& result, const Order& order, const QString& printer, QString& path,
               const Progress& progress, QTextStream& lines) {
        PrintRequest request = printRequest(parser_, {printer, {}}, result.project);
        request.copies = order.copies;
        request.turning = turningOnRoll(result.project);
        request.source = printSource(result.project, order.project);
        const int count = int(result.immersions.size());
        if (order.immersion.value_or(1) > count) {
            throw Error(QStringLiteral("The project has no dip %1").arg(*order.immersion), path);
        }
        std::vector<Sheet> sheets;
        for (int number = 1; number <= count; ++number) {
            if (order.immersion.value_or(number) == number) {
                sheets.push_back(result.immersions[std::size_t(number - 1)].sheet);
            }
        }
        const std::unique_ptr<PrintSystem> system = printSystem();
        const std::vector<PrintPlan> plans = planPrints(*system, sheets, request);
        for (const PrintPlan& plan : plans) {
            for (const QString& warning : plan.warnings) {
                lines << QStringLiteral("%1: %2\n").arg(plan.task.title, warning);
            }
        }
        path = folder_.startPrinting(path);
        printAndReport(*system, plans, progress, lines);
    }

    const QCommandLineParser& parser_;
    Console& console_;
    QString out_;
    std::optional<Advice> required_;
    HotFolder folder_;
    SolverRegistry registry_;
    int failures_ = 0; // jobs that failed, also those that are held because of that
};

class WatchCommand : public Command {
public:
    QString name() const override { return QStringLiteral("watch"); }
    QString summary() const override {
        return QStringLiteral("Runs and prints the jobs that are dropped into a folder.");
    }

    void declare(CommandSyntax& syntax) const override {
        syntax.addPositionalArgument(
            QStringLiteral("FOLDER"),
            QStringLiteral("The folder to watch. Projects and print tickets in it are jobs."));
        declareSettings(syntax);
        syntax.addOption({outOption,
                          QStringLiteral("The folder for the results, one subfolder for each job."),
                          QStringLiteral("DIR")});
        declarePrinterOnly(syntax);
        declareRequired(syntax,
                        QStringLiteral("Holds jobs with a worse verdict than this: print, check "
                                       "(check first, the default) or any."),
                        QStringLiteral("check"));
        syntax.addOption(
            {onceOption, QStringLiteral("Ends when the folder has no more jobs. The exit "
                                        "code is 1 if a job failed.")});
        declareThreads(syntax);
    }

    void run(const QCommandLineParser& parser, Console& console) const override {
        if (parser.value(outOption).isEmpty()) {
            throw UsageError(QStringLiteral("Name the folder for the results with --out DIR"),
                             QStringLiteral("--out"));
        }
        const ThreadLimit threads = threadLimit(parser);
        Watch(parser, console).processJobs();
    }
};

} // namespace

std::unique_ptr<Command> watchCommand() {
    return std::make_unique<WatchCommand>();
}

} // namespace dipwright::cli
