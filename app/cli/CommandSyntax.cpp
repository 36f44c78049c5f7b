#include "cli/CommandSyntax.h"

namespace dipwright::cli {

void fill(QCommandLineParser& parser, const CommandSyntax& syntax) {
    for (const QCommandLineOption& option : syntax.options) {
        parser.addOption(option);
    }
    for (const CommandSyntax::Argument& argument : syntax.arguments) {
        parser.addPositionalArgument(argument.heading, argument.description, argument.name);
    }
}

QStringList typedNames(const QCommandLineOption& option) {
    QStringList typed;
    for (const QString& name : option.names()) {
        typed << QLatin1String(name.size() == 1 ? "-" : "--") + name;
    }
    return typed;
}

} // namespace dipwright::cli
