// Describes the options and arguments of a command. The parser, the help, the manual page and the
// shell completions are made from it.
#pragma once

#include <QCommandLineOption>
#include <QCommandLineParser>
#include <vector>

namespace dipwright::cli {

struct CommandSyntax {
    // Alternatives are separated by |: "list | show KIND NAME". The user fills in words in
    // capitals.
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

// Adds the options and arguments of `syntax` to the parser, which cannot be copied.
void fill(QCommandLineParser& parser, const CommandSyntax& syntax);

// Returns the names as the user types them, "-h" and "--help", in declaration order.
QStringList typedNames(const QCommandLineOption& option);

} // namespace dipwright::cli
