#include "panels/StartPage.h"

#include "document/RecentProjects.h"
#include "look/Icons.h"

#include <QAction>
#include <QCommandLinkButton>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QVBoxLayout>

namespace dipwright {

namespace {

constexpr QSize pictureSize(224, 140);

QIcon recentIcon(const QString& path, const QPalette& palette) {
    QPixmap picture(pictureSize);
    picture.fill(palette.color(QPalette::Window));
    QPainter painter(&picture);
    const QImage thumbnail = projectThumbnail(path);
    if (thumbnail.isNull()) {
        icon(QStringLiteral("immersion"))
            .paint(&painter, QRect(QPoint(), pictureSize).adjusted(80, 38, -80, -38));
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(QRect(QPoint(), pictureSize), thumbnail);
    }
    painter.setPen(palette.color(QPalette::Mid));
    painter.drawRect(0, 0, pictureSize.width() - 1, pictureSize.height() - 1);
    return picture;
}

} // namespace

StartPage::StartPage(QWidget* parent)
    : QWidget(parent), recent_(new QListWidget), recentHint_(nullptr) {
    setObjectName(QStringLiteral("startPage"));
    auto* title = new QLabel(QStringLiteral("Dipwright"));
    QFont large = title->font();
    large.setPointSizeF(large.pointSizeF() * 2.4);
    large.setBold(true);
    title->setFont(large);
    auto* subtitle = new QLabel(tr("From a textured model to a film that can be printed."));
    subtitle->setWordWrap(true);

    auto* actions = new QVBoxLayout;
    auto* logo = new QLabel;
    logo->setPixmap(QIcon(QStringLiteral(":/icons/dipwright.svg")).pixmap(96, 96));
    actions->addWidget(logo);
    actions->addSpacing(4);
    actions->addWidget(title);
    actions->addWidget(subtitle);
    actions->addSpacing(20);
    const auto addButton = [this, actions](const QString& text, const QString& help,
                                           const QString& iconName, void (StartPage::*asked)()) {
        auto* button = new QCommandLinkButton(text, help);
        button->setIcon(icon(iconName));
        button->setIconSize({28, 28});
        connect(button, &QCommandLinkButton::clicked, this, asked);
        button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
        actions->addWidget(button);
    };
    addButton(tr("New Project…"), tr("Start from a textured model: OBJ, PLY, STL, glTF or 3MF."),
              QStringLiteral("document-new"), &StartPage::newAsked);
    addButton(tr("Open Project…"), tr("Continue with a saved project or a sample."),
              QStringLiteral("document-open"), &StartPage::openAsked);
    addButton(tr("Quick Tour"), tr("What is where, in six steps."), QStringLiteral("help"),
              &StartPage::tourAsked);
    actions->addStretch();
    auto* drop = new QLabel(tr("Models and projects can also be dropped on the window."));
    drop->setWordWrap(true);
    drop->setForegroundRole(QPalette::PlaceholderText);
    actions->addWidget(drop);

    auto* recentTitle = new QLabel(tr("Recent projects"));
    QFont bold = recentTitle->font();
    bold.setBold(true);
    recentTitle->setFont(bold);
    recent_->setAccessibleName(tr("Recent projects"));
    recent_->setViewMode(QListView::IconMode);
    recent_->setIconSize(pictureSize);
    recent_->setGridSize({pictureSize.width() + 24, pictureSize.height() + 56});
    recent_->setResizeMode(QListView::Adjust);
    recent_->setMovement(QListView::Static);
    recent_->setWordWrap(true);
    recent_->setFrameShape(QFrame::NoFrame);
    recent_->setContextMenuPolicy(Qt::ActionsContextMenu);
    auto* forget = new QAction(tr("Remove from this list"), recent_);
    connect(forget, &QAction::triggered, this, [this] {
        if (const QListWidgetItem* item = recent_->currentItem()) {
            forgetRecentProject(item->data(Qt::UserRole).toString());
            refresh();
        }
    });
    recent_->addAction(forget);
    connect(recent_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        emit projectChosen(item->data(Qt::UserRole).toString());
    });
    connect(recent_, &QListWidget::itemClicked, recent_, &QListWidget::itemActivated);
    auto* hint = new QLabel(tr("Projects that you open or save appear here."));
    hint->setForegroundRole(QPalette::PlaceholderText);
    recentHint_ = hint;
    auto* right = new QVBoxLayout;
    right->addWidget(recentTitle);
    right->addWidget(recentHint_);
    right->addWidget(recent_, 1);
    right->addStretch();

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(48, 40, 32, 24);
    layout->setSpacing(48);
    layout->addLayout(actions, 2);
    layout->addLayout(right, 5);
    refresh();
}

void StartPage::refresh() {
    recent_->clear();
    for (const QString& path : recentProjects()) {
        const QFileInfo file(path);
        if (file.exists()) {
            auto* item = new QListWidgetItem(recentIcon(path, palette()), file.completeBaseName());
            item->setData(Qt::UserRole, path);
            item->setToolTip(QDir::toNativeSeparators(path));
            recent_->addItem(item);
        }
    }
    recentHint_->setVisible(recent_->count() == 0);
    recent_->setVisible(recent_->count() > 0);
}

} // namespace dipwright
