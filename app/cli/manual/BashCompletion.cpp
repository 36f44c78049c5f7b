#include "cli/manual/Completions.h"
#include "cli/manual/ValueChoices.h"

namespace dipwright::cli {
namespace {

// Returns a call of the script's helper function with the words and the kind of files that it
// offers.
QString offer(const ValueChoices& choices) {
    const QLatin1String files(choices.files      ? "files"
                              : choices.projects ? "projects"
                              : choices.folders  ? "folders"
                                                 : "nothing");
    return QStringLiteral("_dipwright_cli_offer %1 '%2'")
        .arg(files, choices.words.join(QLatin1Char(' ')));
}

QStringList optionNames(const CommandSyntax& syntax) {
    QStringList names;
    for (const QCommandLineOption& option : syntax.options) {
        names += typedNames(option);
    }
    return names;
}

QString valueCases(const QString& command, const CommandSyntax& syntax) {
    QString text;
    for (const QCommandLineOption& option : syntax.options) {
        if (!option.valueName().isEmpty()) {
            QStringList patterns;
            for (const QString& name : typedNames(option)) {
                patterns << QStringLiteral("%1,%2").arg(command, name);
            }
            text += QStringLiteral("    %1) %2; return ;;\n")
                        .arg(patterns.join(QLatin1Char('|')), offer(choicesOf(option.valueName())));
        }
    }
    return text;
}

QString wordCase(const QString& command, const CommandSyntax& syntax) {
    ValueChoices choices;
    if (!syntax.arguments.empty()) {
        choices = choicesOf(syntax.arguments.front().name);
    }
    ValueChoices options;
    options.words = optionNames(syntax);
    return QStringLiteral("    %1,-*) %2 ;;\n    %1,*) %3 ;;\n")
        .arg(command, offer(options), offer(choices));
}

const char* const head =
    R"(# What bash completes after dipwright-cli; made by dipwright-cli manual bash.

# _dipwright_cli_offer files|projects|folders|nothing WORDS, for the word under the cursor
_dipwright_cli_offer() {
    local IFS=$' \t\n' word=${COMP_WORDS[COMP_CWORD]}
    [[ $word == = ]] && word=
    mapfile -t COMPREPLY < <(
        compgen -W "$2" -- "$word"
        case $1 in
        files) compgen -f -- "$word" ;;
        projects) compgen -f -X '!*.dipw' -- "$word"; compgen -d -- "$word" ;;
        folders) compgen -d -- "$word" ;;
        esac
    )
    [[ $1 == nothing ]] || compopt -o filenames 2>/dev/null
}

_dipwright_cli() {
    local before=${COMP_WORDS[COMP_CWORD-1]}
    # --out=results is three words to bash.
    [[ $before == = ]] && before=${COMP_WORDS[COMP_CWORD-2]}
    [[ ${COMP_WORDS[COMP_CWORD]} == = ]] && before=${COMP_WORDS[COMP_CWORD-1]}
)";

} // namespace

QString bashCompletion(const Commands& commands) {
    ValueChoices first;
    QString values, words;
    for (const auto& command : commands) {
        const CommandSyntax syntax = syntaxOf(*command);
        first.words << command->name();
        values += valueCases(command->name(), syntax);
        words += wordCase(command->name(), syntax);
    }
    first.words << QStringLiteral("--help") << QStringLiteral("--version");
    return QString::fromLatin1(head) +
           QStringLiteral("    if ((COMP_CWORD == 1)); then\n        %1\n        return\n    fi\n")
               .arg(offer(first)) +
           QStringLiteral("    case ${COMP_WORDS[1]},$before in\n%1    esac\n").arg(values) +
           QStringLiteral("    case ${COMP_WORDS[1]},${COMP_WORDS[COMP_CWORD]} in\n%1    esac\n}\n"
                          "complete -F _dipwright_cli dipwright-cli\n")
               .arg(words);
}

} // namespace dipwright::cli
