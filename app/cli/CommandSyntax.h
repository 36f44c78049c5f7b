// Describes the options and arguments of a command. The parser, the help, the manual page and the
// shell completions are made from this description.
#pragma once

#include <QCommandLineOption>
#include <QCommandLineParser>
#include <vector>

namespace dipwright::cli {

struct CommandSyntax {
    // In `name`, alternatives are separated by |: "list | show KIND NAME". Words in capitals stand
    // for the user's own words. `heading` stands for a long name in the help's list of arguments.
    struct Argument {
        QString name, description, heading;
    };
    std::vector<QCommandLineOption> options; // in the order in which the help lists them
    std::vector<Argument> arguments;

    void addOption(const QCommandLineOption& option) { options.push_back(option); }
    void addPositionalArgument(const QString& name, const QString& description,
                               const QString& heading = {}) {
        arguments.push_back({name, description, heading.isEmpty() ? name : heading});
    }
};

// Adds the options and arguments of `syntax` to the parser. The parser is changed in place, because
// it cannot be copied.
void fill(QCommandLineParser& parser, const CommandSyntax& syntax);

// Returns the option's names as the user types them, "-h" and "--help", in declaration order.
QStringList typedNames(const QCommandLineOption& option);

} // namespace dipwright::cli
