#include "workbench/serving/ServerDialog.h"

#include "base/Error.h"
#include "disk/SmallFile.h"
#include "workbench/widgets/NoticeBar.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

namespace dipwright {
namespace {

constexpr qint64 longestToken = 4096;
const QString addressKey = QStringLiteral("server/address");
const QString tokenFileKey = QStringLiteral("server/tokenFile"); // the token itself is not kept

bool isPath(const QString& text) {
    return text.contains(u'/');
}

// No error names the text, which may be the token.
QByteArray tokenOf(const QString& text) {
    if (isPath(text) && !QFileInfo(text).isFile()) {
        throw Error(ServerDialog::tr("There is no such file"), {});
    }
    const QByteArray token =
        isPath(text) ? readSmallFile(text, longestToken).trimmed() : text.toLatin1();
    if (token.isEmpty() || token.contains('\n') || token.contains('\r')) {
        throw Error(ServerDialog::tr("Paste the server's token, or write the path of its file"),
                    {});
    }
    return token;
}

} // namespace

ServerDialog::ServerDialog(QWidget* parent)
    : QDialog(parent), notice_(new NoticeBar), address_(new QLineEdit), token_(new QLineEdit) {
    setObjectName(QStringLiteral("serverDialog"));
    setWindowTitle(tr("Send to server"));
    const QSettings settings;
    address_->setObjectName(QStringLiteral("serverAddress"));
    address_->setText(settings.value(addressKey).toString());
    address_->setPlaceholderText(QStringLiteral("127.0.0.1:8137"));
    address_->setToolTip(tr("Where dipwright-cli serve listens: a port of this computer, such as "
                            "127.0.0.1:8137, or the path of a socket. Another computer is reached "
                            "through an SSH tunnel."));
    token_->setObjectName(QStringLiteral("serverToken"));
    token_->setText(settings.value(tokenFileKey).toString());
    token_->setToolTip(tr("The token that the server asks for, or the path of the file that holds "
                          "it. Only the path is remembered."));
    const auto hideToken = [this] {
        token_->setEchoMode(isPath(token_->text()) ? QLineEdit::Normal : QLineEdit::Password);
    };
    connect(token_, &QLineEdit::textChanged, this, hideToken);
    hideToken();
    auto* words = new QLabel(tr("The server simulates the dips of this project. Its results then "
                                "appear here like those of a run on this computer."));
    words->setWordWrap(true);
    auto* form = new QFormLayout;
    form->addRow(tr("&Address"), address_);
    form->addRow(tr("&Token or its file"), token_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    buttons->addButton(tr("&Send"), QDialogButtonBox::AcceptRole)->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &ServerDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &ServerDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(notice_);
    layout->addWidget(words);
    layout->addLayout(form);
    layout->addStretch();
    layout->addWidget(buttons);
    resize(520, 220);
}

void ServerDialog::accept() {
    try {
        const QString token = token_->text().trimmed();
        const ServerAccess server{serverAddress(address_->text()), tokenOf(token)};
        QSettings settings;
        settings.setValue(addressKey, server.address.text());
        settings.setValue(tokenFileKey, isPath(token) ? token : QString());
        emit sent(server);
        QDialog::accept();
    } catch (const Error& error) {
        notice_->say(error.sentence());
    }
}

} // namespace dipwright
