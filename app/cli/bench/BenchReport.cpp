#include "cli/bench/BenchReport.h"

#include <QJsonArray>

namespace dipwright::cli {
namespace {

// Returns the row's operations per second as a share of the device's ceiling; null without a
// ceiling.
QJsonValue ceilingShare(const StepRow& row, const std::optional<solver::Ceiling>& ceiling) {
    return ceiling ? QJsonValue(row.flopsPerSecond() / ceiling->flopsPerSecond) : QJsonValue();
}

QJsonArray stepsJson(const std::vector<StepRow>& rows, const BenchReport& report) {
    QJsonArray array;
    for (const StepRow& row : rows) {
        array.append(QJsonObject{{"body", row.body},
                                 {"field_samples", row.fieldSamples},
                                 {"points", row.points},
                                 {"constraints", row.constraints},
                                 {"steps_per_second", row.stepsPerSecond.median},
                                 {"min", row.stepsPerSecond.minimum},
                                 {"max", row.stepsPerSecond.maximum},
                                 {"constraint_solves_per_second", row.solvesPerSecond()},
                                 {"flops_per_second", row.flopsPerSecond()},
                                 {"share_of_ceiling", ceilingShare(row, report.ceiling)},
                                 {"paper", row.paper ? QJsonValue(*row.paper) : QJsonValue()}});
    }
    return array;
}

QJsonArray secondsJson(const std::vector<TimedRow>& rows) {
    QJsonArray array;
    for (const TimedRow& row : rows) {
        QJsonObject object = row.facts;
        object["seconds"] = row.seconds.median;
        object["min"] = row.seconds.minimum;
        object["max"] = row.seconds.maximum;
        array.append(object);
    }
    return array;
}

QString inBillions(double value, int decimals) {
    return QString::number(value / 1e9, 'f', decimals);
}

void printCells(const QStringList& cells, QTextStream& out) {
    static const std::array<int, 10> widths{12, 7, 8, 12, 9, 9, 9, 10, 9, 7};
    for (int i = 0; i < cells.size(); ++i) {
        const int width = widths[std::size_t(i)];
        out << (i == 0 ? cells[i].leftJustified(width) : cells[i].rightJustified(width));
    }
    out << '\n';
}

void printSteps(const QString& title, const std::vector<StepRow>& rows, const BenchReport& report,
                QTextStream& out) {
    if (rows.empty()) {
        return;
    }
    out << '\n' << title << '\n';
    printCells({QStringLiteral("body"), QStringLiteral("field"), QStringLiteral("points"),
                QStringLiteral("constraints"), QStringLiteral("steps/s"), QStringLiteral("min"),
                QStringLiteral("max"), QStringLiteral("Gsolves/s"), QStringLiteral("ceiling"),
                QStringLiteral("paper")},
               out);
    const auto rate = [](double value) { return QString::number(value, 'f', 0); };
    for (const StepRow& row : rows) {
        const QString share =
            report.ceiling
                ? QStringLiteral("%1 %").arg(
                      100 * row.flopsPerSecond() / report.ceiling->flopsPerSecond, 0, 'f', 1)
                : QStringLiteral("–");
        printCells({row.body, cubed(row.fieldSamples), QString::number(row.points),
                    QString::number(row.constraints), rate(row.stepsPerSecond.median),
                    rate(row.stepsPerSecond.minimum), rate(row.stepsPerSecond.maximum),
                    inBillions(row.solvesPerSecond(), 2), share,
                    row.paper ? rate(*row.paper) : QStringLiteral("–")},
                   out);
    }
}

void printSeconds(const QString& title, const std::vector<TimedRow>& rows, QTextStream& out) {
    if (rows.empty()) {
        return;
    }
    out << '\n' << title << '\n';
    for (const TimedRow& row : rows) {
        out << QStringLiteral("%1  %2 s (%3 … %4)\n")
                   .arg(row.what, -52)
                   .arg(row.seconds.median, 0, 'f', 3)
                   .arg(row.seconds.minimum, 0, 'f', 3)
                   .arg(row.seconds.maximum, 0, 'f', 3);
    }
}

QJsonArray liveJson(const std::vector<LiveRow>& rows) {
    QJsonArray array;
    for (const LiveRow& row : rows) {
        array.append(QJsonObject{{"model", row.model},
                                 {"first_answer_s", row.firstAnswer.median},
                                 {"first_answer_max_s", row.firstAnswer.maximum},
                                 {"dips_per_second", row.dipsPerSecond},
                                 {"final_s", row.final.median},
                                 {"final_max_s", row.final.maximum}});
    }
    return array;
}

void printLive(const std::vector<LiveRow>& rows, QTextStream& out) {
    if (rows.empty()) {
        return;
    }
    out << "\nAfter the part is turned\n";
    for (const LiveRow& row : rows) {
        out << QStringLiteral("%1  first draft %2 s (at most %3), %4 drafts/s while dragging, "
                              "result %5 s (at most %6)\n")
                   .arg(row.model, -14)
                   .arg(row.firstAnswer.median, 0, 'f', 3)
                   .arg(row.firstAnswer.maximum, 0, 'f', 3)
                   .arg(row.dipsPerSecond, 0, 'f', 1)
                   .arg(row.final.median, 0, 'f', 2)
                   .arg(row.final.maximum, 0, 'f', 2);
    }
}

} // namespace

QJsonObject toJson(const BenchReport& report) {
    QJsonObject json{{"version", 1},
                     {"solver", report.solver.id},
                     {"device", report.device},
                     {"runs", report.runs},
                     {"ceiling", QJsonValue()}};
    if (report.ceiling) {
        json["ceiling"] = QJsonObject{{"flops_per_second", report.ceiling->flopsPerSecond},
                                      {"bytes_per_second", report.ceiling->bytesPerSecond}};
    }
    json["table1"] = stepsJson(report.tableOne, report);
    json["figure7"] = stepsJson(report.fieldSweep, report);
    json["dips"] = secondsJson(report.dips);
    json["fields"] = secondsJson(report.fields);
    json["sheets"] = secondsJson(report.sheets);
    json["parts_of_a_run"] = secondsJson(report.runParts);
    json["runs_of_the_turtle"] = secondsJson(report.wholeRuns);
    json["live"] = liveJson(report.live);
    return json;
}

void print(const BenchReport& report, QTextStream& out) {
    out << QStringLiteral("%1 %2 on %3, medians of %4 runs\n")
               .arg(report.solver.name, report.solver.version, report.device)
               .arg(report.runs);
    if (report.ceiling) {
        out << QStringLiteral(
                   "Ceiling of the device (on a CPU: of the threads used): %1 Gflop/s, %2 GB/s\n")
                   .arg(inBillions(report.ceiling->flopsPerSecond, 0),
                        inBillions(report.ceiling->bytesPerSecond, 1));
    }
    printSteps(QStringLiteral("Table I: whole dips of the sphere, preset paper-2020"),
               report.tableOne, report, out);
    printSteps(QStringLiteral("Figure 7: fields from coarse to fine, preset paper-2020"),
               report.fieldSweep, report, out);
    printSeconds(QStringLiteral("Whole dips of the sphere"), report.dips, out);
    printSeconds(QStringLiteral("Building the distance field of a sphere"), report.fields, out);
    printSeconds(QStringLiteral("The turtle's sheet"), report.sheets, out);
    printSeconds(QStringLiteral("The steps of a run other than the dip"), report.runParts, out);
    printSeconds(QStringLiteral("The whole job"), report.wholeRuns, out);
    printLive(report.live, out);
}

} // namespace dipwright::cli
