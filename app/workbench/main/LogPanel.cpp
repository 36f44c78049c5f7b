#include "workbench/main/LogPanel.h"

#include "workbench/widgets/Icons.h"

#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTime>
#include <QVBoxLayout>

namespace dipwright {

namespace {

constexpr int mostLines = 5000;

} // namespace

LogPanel::LogPanel(QWidget* parent) : QWidget(parent), text_(new QPlainTextEdit) {
    text_->setReadOnly(true);
    text_->setMaximumBlockCount(mostLines);
    text_->setAccessibleName(tr("Log"));
    text_->setPlaceholderText(tr("Nothing has happened yet."));
    auto* copy = new QPushButton(icon(QStringLiteral("copy")), tr("Copy report"));
    copy->setToolTip(
        tr("Copies the log, with details of the program and the computer, to the clipboard."));
    copy->setObjectName(QStringLiteral("copyReport"));
    connect(copy, &QPushButton::clicked, this, &LogPanel::reportAsked);
    auto* clear = new QPushButton(tr("Clear"));
    clear->setToolTip(tr("Empties the log."));
    connect(clear, &QPushButton::clicked, text_, &QPlainTextEdit::clear);
    auto* row = new QHBoxLayout;
    row->addWidget(copy);
    row->addWidget(clear);
    row->addStretch();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(text_);
    layout->addLayout(row);
}

void LogPanel::add(const QString& line) {
    text_->appendPlainText(QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + line);
}

QString LogPanel::text() const {
    return text_->toPlainText();
}

} // namespace dipwright
