#include "cli/manual/Completions.h"
#include "cli/manual/ValueChoices.h"

namespace dipwright::cli {
namespace {

// Escapes text for single quotes in zsh, and colons and brackets for _arguments.
QString quoted(QString text) {
    for (const char special : {'\\', ':', '[', ']'}) {
        text.replace(QLatin1Char(special), QLatin1Char('\\') + QString(QLatin1Char(special)));
    }
    return text.replace(QLatin1Char('\''), QLatin1String("'\\''"));
}

// Returns an action for _arguments. Colons inside the action are escaped, because a colon ends an
// action. A leading space makes zsh call the action unchanged.
QString action(const ValueChoices& choices) {
    const QString words = QStringLiteral("(%1)").arg(choices.words.join(QLatin1Char(' ')));
    const QLatin1String files(choices.files      ? "_files"
                              : choices.projects ? "_files -g \"*.dipw\""
                              : choices.folders  ? "_files -/"
                                                 : " ");
    if (choices.words.isEmpty()) {
        return files;
    }
    if (files == QLatin1String(" ")) {
        return words;
    }
    return QStringLiteral(" _alternative \"words\\:word\\:%1\" \"files\\:file\\:_files\"")
        .arg(words);
}

QString optionSpec(const QString& name, const QCommandLineOption& option) {
    const QString text = quoted(option.description());
    if (option.valueName().isEmpty()) {
        return QStringLiteral("'%1[%2]'").arg(name, text);
    }
    return QStringLiteral("'*%1[%2]:%3:%4'")
        .arg(name, text, quoted(option.valueName()), action(choicesOf(option.valueName())));
}

QString commandCase(const QString& command, const CommandSyntax& syntax) {
    QStringList specs;
    for (const QCommandLineOption& option : syntax.options) {
        for (const QString& name : typedNames(option)) {
            specs << optionSpec(name, option);
        }
    }
    for (const CommandSyntax::Argument& argument : syntax.arguments) {
        specs << QStringLiteral("'*:%1:%2'")
                     .arg(quoted(argument.name.section(QLatin1Char(' '), 0, 0)),
                          action(choicesOf(argument.name)));
    }
    return QStringLiteral("    %1)\n        _arguments \\\n            %2\n        ;;\n")
        .arg(command, specs.join(QStringLiteral(" \\\n            ")));
}

} // namespace

QString zshCompletion(const Commands& commands) {
    QString list, cases;
    for (const auto& command : commands) {
        list +=
            QStringLiteral("        '%1:%2'\n").arg(command->name(), quoted(command->summary()));
        cases += commandCase(command->name(), syntaxOf(*command));
    }
    return QStringLiteral(
               "#compdef dipwright-cli\n"
               "# Completions of dipwright-cli for zsh, made by dipwright-cli manual zsh.\n\n"
               "_dipwright-cli() {\n"
               "    local -a commands=(\n%1    )\n"
               "    if (( CURRENT == 2 )); then\n"
               "        _describe command commands\n"
               "        return\n"
               "    fi\n"
               "    local command=$words[2]\n"
               "    shift words\n"
               "    (( CURRENT-- ))\n"
               "    case $command in\n%2    esac\n}\n\n"
               "_dipwright-cli \"$@\"\n")
        .arg(list, cases);
}

} // namespace dipwright::cli
