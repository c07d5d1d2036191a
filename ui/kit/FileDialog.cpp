// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/FileDialog.h"

#include <QDir>
#include <QFileIconProvider>
#include <QFileInfo>
#include <QFileSystemModel>
#include <QGridLayout>
#include <QHeaderView>
#include <QIdentityProxyModel>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMimeDatabase>
#include <QRegularExpression>
#include <QTreeView>

#include "ui/kit/Accessibility.h"
#include "ui/kit/AppSettings.h"

namespace ui::kit {
namespace {

constexpr int kSize = 1;  ///< columns of QFileSystemModel
constexpr int kKind = 2;
constexpr int kModified = 3;

/// Returns "*.png" and "*.PNG" for "Pictures (*.png *.PNG)".
QStringList patternsOf(const QStringList& nameFilters)
{
    static const QRegularExpression kWithin(QStringLiteral(R"(\(([^()]*)\)\s*$)"));
    QStringList patterns;
    for (const QString& filter : nameFilters)
        patterns << kWithin.match(filter).captured(1).split(u' ', Qt::SkipEmptyParts);
    return patterns;
}

/// Chooses icons by file name, and never opens a file.
class ByName final : public QFileIconProvider
{
public:
    using QFileIconProvider::icon;
    [[nodiscard]] QIcon icon(const QFileInfo& info) const override
    {
        return QFileIconProvider::icon(info.isDir() ? IconType::Folder : IconType::File);
    }
    [[nodiscard]] QString type(const QFileInfo& info) const override
    {
        return info.isDir() ? QString()
                            : QMimeDatabase().mimeTypeForFile(info.fileName(), QMimeDatabase::MatchExtension).comment();
    }
};

/// Formats sizes and dates in the program's language. Qt's own model uses the system's language.
class InProgramsLanguage final : public QIdentityProxyModel
{
public:
    using QIdentityProxyModel::QIdentityProxyModel;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override
    {
        const auto* files = qobject_cast<const QFileSystemModel*>(sourceModel());
        if (role == Qt::DisplayRole && files != nullptr) {
            const QModelIndex at = mapToSource(index);
            if (index.column() == kSize && !files->isDir(at))
                return QLocale().formattedDataSize(files->size(at));
            if (index.column() == kModified)
                return QLocale().toString(files->lastModified(at), QLocale::ShortFormat);
        }
        return QIdentityProxyModel::data(index, role);
    }
};

}  // namespace

// QFileDialog lists its folder at once. It therefore begins in the root folder, where no database is, and changes to
// the requested folder after its icon provider has been set.
FileDialog::FileDialog(QWidget* parent, const QString& title, const QString& folder, const QString& filter)
    : QFileDialog(parent, title, QDir::rootPath(), filter), m_refusal(new QLabel(this))
{
    static ByName byName;
    setAttribute(Qt::WA_DeleteOnClose);
    setOption(DontUseNativeDialog);  // a desktop's own dialog may open files to preview them
    setIconProvider(&byName);
    setProxyModel(new InProgramsLanguage(this));
    setDirectory(folder);
    m_refusal->setObjectName(QStringLiteral("refusal"));
    m_refusal->setWordWrap(true);
    m_refusal->hide();
    if (auto* rows = qobject_cast<QGridLayout*>(layout()))
        rows->addWidget(m_refusal, rows->rowCount(), 0, 1, rows->columnCount());
    if (auto* name = findChild<QLineEdit*>(QStringLiteral("fileNameEdit")))
        connect(name, &QLineEdit::textChanged, m_refusal, &QWidget::hide);
    // Qt sizes the columns for English dates, which is too narrow for other languages.
    if (auto* list = findChild<QTreeView*>(QStringLiteral("treeView")))
        for (const int column : {kSize, kKind, kModified})
            list->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    // Without a window manager, no one else returns the focus to the parent window.
    if (parent != nullptr)
        connect(this, &QDialog::finished, parent->window(), [window = parent->window()] { window->activateWindow(); });
}

void FileDialog::askWhere(const QString& name, const QString& ending)
{
    static const QRegularExpression kUnfit(QStringLiteral(R"([^\w .,()-]+)"),
                                           QRegularExpression::UseUnicodePropertiesOption);
    const QString key = QStringLiteral("folders/export");
    const QString last = memory().value(key).toString();
    if (QFileInfo(last).isDir())
        setDirectory(last);
    setAcceptMode(AcceptSave);
    setDefaultSuffix(ending);
    selectFile(QString(name).replace(kUnfit, QStringLiteral(" ")).simplified() + u'.' + ending);
    connect(this, &QFileDialog::fileSelected, this,
            [key](const QString& path) { memory().setValue(key, QFileInfo(path).absolutePath()); });
    open();
}

void FileDialog::accept()
{
    if (acceptMode() == AcceptSave)
        for (const QString& file : selectedFiles()) {
            const QFileInfo there(QFileInfo(file).canonicalFilePath());  // target of a link
            if (there.isFile() && !QDir::match(patternsOf(nameFilters()), there.fileName())) {
                m_refusal->setText(
                    tr("%1 is a file of another kind and stays as it is. Choose another name.").arg(there.fileName()));
                m_refusal->show();
                announce(*m_refusal);
                return;
            }
        }
    QFileDialog::accept();
}

}  // namespace ui::kit
