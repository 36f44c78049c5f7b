#include "cli/manual/Completions.h"
#include "cli/manual/ValueChoices.h"

namespace dipwright::cli {
namespace {

QString quoted(QString text) {
    text.replace(QLatin1Char('\\'), QLatin1String("\\\\"));
    return QLatin1Char('\'') + text.replace(QLatin1Char('\''), QLatin1String("\\'")) +
           QLatin1Char('\'');
}

// In fish, -F offers files in addition to the given words; -f offers only the words.
QString offer(const ValueChoices& choices) {
    QStringList offered = choices.words;
    if (choices.projects) {
        offered << QStringLiteral("(__fish_complete_suffix .dipw)");
    } else if (choices.folders) {
        offered << QStringLiteral("(__fish_complete_directories)");
    }
    const QString files = QLatin1String(choices.files ? "-F" : "-f");
    return offered.isEmpty()
               ? files
               : QStringLiteral("%1 -a %2").arg(files, quoted(offered.join(QLatin1Char(' '))));
}

QString optionLine(const QString& condition, const QCommandLineOption& option) {
    QString line = condition;
    for (const QString& name : option.names()) {
        line += QStringLiteral(" %1 %2").arg(QLatin1String(name.size() == 1 ? "-s" : "-l"), name);
    }
    if (!option.valueName().isEmpty()) {
        line += QStringLiteral(" -r ") + offer(choicesOf(option.valueName()));
    }
    return line + QStringLiteral(" -d %1\n").arg(quoted(option.description()));
}

} // namespace

QString fishCompletion(const Commands& commands) {
    QString text = QStringLiteral(
        "# Completions of dipwright-cli for fish, made by dipwright-cli manual fish.\n");
    for (const auto& command : commands) {
        const CommandSyntax syntax = syntaxOf(*command);
        text +=
            QStringLiteral("complete -c dipwright-cli -n __fish_use_subcommand -f -a %1 -d %2\n")
                .arg(command->name(), quoted(command->summary()));
        const QString condition =
            QStringLiteral("complete -c dipwright-cli -n '__fish_seen_subcommand_from %1'")
                .arg(command->name());
        const ValueChoices words =
            syntax.arguments.empty() ? ValueChoices() : choicesOf(syntax.arguments.front().name);
        text += QStringLiteral("%1 %2\n").arg(condition, offer(words));
        for (const QCommandLineOption& option : syntax.options) {
            text += optionLine(condition, option);
        }
    }
    return text;
}

} // namespace dipwright::cli
