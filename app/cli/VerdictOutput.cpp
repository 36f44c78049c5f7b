#include "cli/VerdictOutput.h"

#include "pipeline/InkOptions.h"
#include "pipeline/JobVerdict.h"

#include <QCoreApplication>

#include <algorithm>

namespace dipwright::cli {

namespace {

const QString requireOption = QStringLiteral("require");

} // namespace

void declareRequired(CommandSyntax& syntax, const QString& description, const QString& byDefault) {
    syntax.addOption({requireOption, description, QStringLiteral("print|check|any"), byDefault});
}

std::optional<Advice> requiredAdvice(const QCommandLineParser& parser) {
    const QString word = parser.value(requireOption);
    if (word == QLatin1String("any")) {
        return std::nullopt;
    }
    if (word == QLatin1String("print")) {
        return Advice::Print;
    }
    if (word == QLatin1String("check")) {
        return Advice::CheckFirst;
    }
    throw UsageError(QStringLiteral("“%1” is not a verdict; require print, check or any").arg(word),
                     QStringLiteral("--require"));
}

Advice verdictToCompare(const JobResult& result) {
    const bool isJudged = std::ranges::none_of(reasonsOf(result), [](const JobReason& reason) {
        return reason.reason.kind == VerdictReason::Kind::NotAsked;
    });
    return isJudged ? adviceOf(result) : Advice::NotJudged;
}

bool isWorse(Advice verdict, Advice required) {
    return verdict == Advice::NotJudged || verdict > required;
}

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Verdict)
};

// Prints what helps where ink does not suffice.
void printInkOptions(const JobResult& result, QTextStream& out) {
    const std::optional<InkOptions> found = inkOptions(result, {});
    if (!found) {
        return;
    }
    out << "  " << Text::tr("Ink now: %1").arg(reachText(found->now)) << '\n';
    for (const InkOption& option : found->options) {
        const QString setting =
            option.remedy == InkRemedy::OtherPose ? QStringLiteral("optimize")
            : option.remedy == InkRemedy::WhiteBeneath
                ? QStringLiteral("--set sheet.white=last")
                : QStringLiteral("--set %1=%2").arg(remedyField(option.remedy)).arg(option.value);
        out << QStringLiteral("  %1 (%2): %3\n")
                   .arg(remedyText(option), setting, optionText(option));
    }
}

} // namespace

void printVerdict(const JobResult& result, QTextStream& out) {
    out << adviceText(adviceOf(result)).toUpper() << '\n';
    for (const JobReason& reason : reasonsOf(result)) {
        out << QStringLiteral("  %1\n").arg(reasonText(reason, result, millimetres));
        if (reason.reason.kind == VerdictReason::Kind::Pale) {
            printInkOptions(result, out);
        }
    }
}

} // namespace dipwright::cli
