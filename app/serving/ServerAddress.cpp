#include "serving/ServerAddress.h"

#include "base/Error.h"

#include <QCoreApplication>
#include <QDir>
#include <QRegularExpression>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Serving)
};

} // namespace

QString ServerAddress::text() const {
    return isSocket() ? socket
                      : QStringLiteral("%1:%2")
                            .arg(host.contains(u':') ? QStringLiteral("[%1]").arg(host) : host)
                            .arg(port);
}

ServerAddress serverAddress(const QString& text) {
    static const QRegularExpression pattern(
        QStringLiteral("^(?:(?:http://)?(\\[[^\\]]+\\]|[^:/\\[\\]]+):)?(\\d{1,5})/?$"));
    const QString trimmed = text.trimmed();
    ServerAddress address;
    if (trimmed.startsWith(u'/')) {
        address.socket = QDir::cleanPath(trimmed);
        return address;
    }
    const QRegularExpressionMatch match = pattern.match(trimmed);
    address.port = match.captured(2).toInt();
    if (!match.hasMatch() || address.port < 1 || address.port > 65535) {
        throw Error(
            Text::tr("Write the path of a socket, such as /run/user/1000/dipwright.sock, or "
                     "a port of this computer, such as 127.0.0.1:8137"),
            text);
    }
    const QString host = match.captured(1).remove(u'[').remove(u']').toLower();
    if (host == u"::1") {
        address.host = host;
    } else if (!host.isEmpty() && host != u"127.0.0.1" && host != u"localhost") {
        throw Error(Text::tr("Only addresses of this computer are possible, because the connection "
                             "is not encrypted. Reach another computer through an SSH tunnel: "
                             "ssh -L 8137:127.0.0.1:8137 USER@COMPUTER"),
                    text);
    }
    return address;
}

} // namespace dipwright
