#include "cli/Arguments.h"
#include "cli/manual/Completions.h"
#include "cli/manual/ManualPage.h"

#include <QCoreApplication>

namespace dipwright::cli {
namespace {

const QString formArgument = QStringLiteral("man|bash|zsh|fish");

class ManualCommand : public Command {
public:
    QString name() const override { return QStringLiteral("manual"); }
    QString summary() const override {
        return QStringLiteral("Prints the manual page or the completion script for a shell.");
    }
    bool needsFiles() const override { return false; }
    void declare(CommandSyntax& syntax) const override {
        syntax.addPositionalArgument(
            formArgument,
            QStringLiteral("The format: a page for man, or a script for a shell, for "
                           "example: source <(dipwright-cli manual bash)."),
            QStringLiteral("FORMAT"));
    }
    void run(const QCommandLineParser& parser, Console& console) const override {
        const QString form = positionalArgument(parser, formArgument);
        const auto commands = allCommands();
        if (form == QLatin1String("man")) {
            console.out() << manualPage(commands, QCoreApplication::applicationVersion());
        } else if (form == QLatin1String("bash")) {
            console.out() << bashCompletion(commands);
        } else if (form == QLatin1String("zsh")) {
            console.out() << zshCompletion(commands);
        } else if (form == QLatin1String("fish")) {
            console.out() << fishCompletion(commands);
        } else {
            throw UsageError(
                QStringLiteral("There is no such format; choose man, bash, zsh or fish"), form);
        }
    }
};

} // namespace

std::unique_ptr<Command> manualCommand() {
    return std::make_unique<ManualCommand>();
}

} // namespace dipwright::cli
