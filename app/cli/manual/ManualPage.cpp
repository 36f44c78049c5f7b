#include "cli/manual/ManualPage.h"

#include <QStringList>

namespace dipwright::cli {
namespace {

// Escapes backslashes and hyphens, and a leading character that roff would read as a request.
QString roff(QString text) {
    text.replace(QLatin1Char('\\'), QLatin1String("\\e"));
    text.replace(QLatin1Char('-'), QLatin1String("\\-"));
    if (text.startsWith(QLatin1Char('.')) || text.startsWith(QLatin1Char('\''))) {
        text.prepend(QLatin1String("\\&"));
    }
    return text;
}

QString bold(const QString& text) {
    return QStringLiteral("\\fB%1\\fR").arg(roff(text));
}

QString italic(const QString& text) {
    return QStringLiteral("\\fI%1\\fR").arg(roff(text));
}

QString entry(const QString& head, const QString& text) {
    return QStringLiteral(".TP\n%1\n%2\n").arg(head, roff(text));
}

QString optionEntry(const QCommandLineOption& option) {
    QStringList names;
    for (const QString& name : typedNames(option)) {
        names << bold(name);
    }
    QString head = names.join(QStringLiteral(", "));
    if (!option.valueName().isEmpty()) {
        head += QLatin1Char(' ') + italic(option.valueName());
    }
    return entry(head, option.description());
}

// Describes the command with its own options and arguments. Options of all commands are listed
// once, at the end.
QString commandSection(const Command& command) {
    CommandSyntax syntax;
    command.declare(syntax);
    QString usage = bold(command.name());
    for (const CommandSyntax::Argument& argument : syntax.arguments) {
        usage += QLatin1Char(' ') + italic(argument.name);
    }
    QString text = QStringLiteral(".SS %1\n%2\n.PP\n%3\n")
                       .arg(roff(command.name()), usage, roff(command.summary()));
    for (const CommandSyntax::Argument& argument : syntax.arguments) {
        text += entry(italic(argument.name), argument.description);
    }
    for (const QCommandLineOption& option : syntax.options) {
        text += optionEntry(option);
    }
    return text;
}

QString commonOptions(const Command& any) {
    CommandSyntax own;
    any.declare(own);
    const CommandSyntax all = syntaxOf(any);
    QString text;
    for (std::size_t i = 0; i + own.options.size() < all.options.size(); ++i) {
        text += optionEntry(all.options[i]);
    }
    return text;
}

} // namespace

QString manualPage(const std::vector<std::unique_ptr<Command>>& commands, const QString& version) {
    QString text =
        QStringLiteral(
            ".TH DIPWRIGHT\\-CLI 1 \"\" \"Dipwright %1\" \"User Commands\"\n"
            ".SH NAME\n"
            "dipwright\\-cli \\- computational hydrographic printing on the command line\n"
            ".SH SYNOPSIS\n"
            ".B dipwright\\-cli\n"
            ".I COMMAND\n"
            "[options] ...\n"
            ".SH DESCRIPTION\n"
            "Computes the sheet to print on a water transfer film from a textured model. The film\n"
            "floats on water; when the part is dipped through it, the texture lands in its place.\n"
            ".SH COMMANDS\n")
            .arg(roff(version));
    for (const auto& command : commands) {
        text += commandSection(*command);
    }
    text += QStringLiteral(".SH OPTIONS OF ALL COMMANDS\n") + commonOptions(*commands.front());
    text += QStringLiteral(".SH EXIT STATUS\n") +
            entry(QStringLiteral("0"), QStringLiteral("Done.")) +
            entry(QStringLiteral("1"), QStringLiteral("The job failed.")) +
            entry(QStringLiteral("2"), QStringLiteral("Wrong usage."));
    text += QStringLiteral(".SH ENVIRONMENT\n") +
            entry(bold(QStringLiteral("DIPWRIGHT_PLUGIN_PATH")),
                  QStringLiteral("Folders with additional solver plugins, separated as in PATH.")) +
            entry(bold(QStringLiteral("DIPWRIGHT_PROFILE_PATH")),
                  QStringLiteral("The folder of the user's profiles.")) +
            entry(bold(QStringLiteral("DIPWRIGHT_CACHE")),
                  QStringLiteral("The folder that caches distance fields."));
    text += QStringLiteral(".SH SEE ALSO\n.BR dipwright (1)\n");
    return text;
}

} // namespace dipwright::cli
