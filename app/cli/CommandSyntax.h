// What may be written after a command: made into its parser, its help, the manual page and what
// shells complete.
#pragma once

#include <QCommandLineOption>
#include <QCommandLineParser>
#include <vector>

namespace dipwright::cli {

struct CommandSyntax {
    // An alternative a word: "list | show KIND NAME". Capitals stand for what the user fills in.
    struct Argument {
        QString name, description;
    };
    std::vector<QCommandLineOption> options; // in the order in which they are listed
    std::vector<Argument> arguments;

    void addOption(const QCommandLineOption& option) { options.push_back(option); }
    void addPositionalArgument(const QString& name, const QString& description) {
        arguments.push_back({name, description});
    }
};

// Understands what `syntax` has. Not copyable, and so filled in place.
void fill(QCommandLineParser& parser, const CommandSyntax& syntax);

// "-h", "--help": as they are typed, in the order in which they were declared.
QStringList typedNames(const QCommandLineOption& option);

} // namespace dipwright::cli
