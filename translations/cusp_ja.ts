<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja_JP" sourcelanguage="en_US">
<context>
    <name>Admin</name>
    <message>
        <source>erased a person</source>
        <translation>人の情報を消去しました</translation>
    </message>
    <message>
        <source>erased a comment</source>
        <translation>コメントを消去しました</translation>
    </message>
    <message>
        <source>erased the reason for a score</source>
        <translation>点数の理由を消去しました</translation>
    </message>
    <message>
        <source>This person was erased and cannot come back.</source>
        <translation>この人の情報は消去されており、元に戻せません。</translation>
    </message>
    <message>
        <source>Erase %1?</source>
        <translation>%1 の情報を消去しますか？</translation>
    </message>
    <message>
        <source>The names, the login and the comments by and about this person are removed. The attempts and scores stay, under a pseudonym. This cannot be undone, and it does not reach backups and exported files.</source>
        <translation>この人の名前、ログイン情報、この人が書いたコメントとこの人へのコメントを消去します。試行と点数は仮名で残ります。元に戻すことはできません。バックアップと書き出したファイルからは消えません。</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>消去</translation>
    </message>
    <message>
        <source>&amp;Keep the person</source>
        <translation>残す(&amp;K)</translation>
    </message>
    <message>
        <source>an attempt was compared with the assigned version</source>
        <translation>試行が課された版と比較された</translation>
    </message>
    <message>
        <source>marked an attempt again from its recording</source>
        <translation>記録から試行を採点し直した</translation>
    </message>
    <message>
        <source>found an older copy in the place of the database</source>
        <translation>データベースの代わりに古いコピーを見つけた</translation>
    </message>
    <message>
        <source>logged in</source>
        <translation>ログインしました</translation>
    </message>
    <message>
        <source>logged out</source>
        <translation>ログアウトしました</translation>
    </message>
    <message>
        <source>a login failed</source>
        <translation>ログインに失敗しました</translation>
    </message>
    <message>
        <source>used a one-time code</source>
        <translation>ワンタイムコードを使いました</translation>
    </message>
    <message>
        <source>changed the password</source>
        <translation>パスワードを変更しました</translation>
    </message>
    <message>
        <source>reset a password</source>
        <translation>パスワードをリセットしました</translation>
    </message>
    <message>
        <source>entered a person</source>
        <translation>人を登録しました</translation>
    </message>
    <message>
        <source>changed a person</source>
        <translation>人の情報を変更しました</translation>
    </message>
    <message>
        <source>added a class</source>
        <translation>クラスを追加しました</translation>
    </message>
    <message>
        <source>renamed a class</source>
        <translation>クラス名を変更しました</translation>
    </message>
    <message>
        <source>put somebody into a class</source>
        <translation>クラスに入れました</translation>
    </message>
    <message>
        <source>took somebody out of a class</source>
        <translation>クラスから外しました</translation>
    </message>
    <message>
        <source>gave a lesson to a class</source>
        <translation>クラスに課題を出しました</translation>
    </message>
    <message>
        <source>took a lesson back</source>
        <translation>課題を取り消しました</translation>
    </message>
    <message>
        <source>an attempt was kept</source>
        <translation>試行が保存されました</translation>
    </message>
    <message>
        <source>commented on an attempt</source>
        <translation>試行にコメントしました</translation>
    </message>
    <message>
        <source>gave another score</source>
        <translation>点数を変更しました</translation>
    </message>
    <message>
        <source>kept a hardness preset</source>
        <translation>硬さプリセットを保存しました</translation>
    </message>
    <message>
        <source>changed a setting</source>
        <translation>設定を変更しました</translation>
    </message>
    <message>
        <source>a backup was restored</source>
        <translation>バックアップが復元されました</translation>
    </message>
    <message>
        <source>guest</source>
        <translation>ゲスト</translation>
    </message>
    <message>
        <source>student</source>
        <translation>学生</translation>
    </message>
    <message>
        <source>instructor</source>
        <translation>教員</translation>
    </message>
    <message>
        <source>admin</source>
        <translation>管理者</translation>
    </message>
    <message>
        <source>nobody</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>the program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>began an exam</source>
        <translation>試験を開始しました</translation>
    </message>
    <message>
        <source>found the audit changed</source>
        <translation>監査記録の改変を検出</translation>
    </message>
    <message>
        <source>made a backup</source>
        <translation>バックアップを作成</translation>
    </message>
    <message>
        <source>exported attempts</source>
        <translation>試行を書き出し</translation>
    </message>
    <message>
        <source>copied the school into another database</source>
        <translation>学校を別のデータベースにコピー</translation>
    </message>
    <message>
        <source>another name</source>
        <translation>名前を変更</translation>
    </message>
    <message>
        <source>a name that nobody has</source>
        <translation>誰のものでもない名前</translation>
    </message>
    <message>
        <source>brought the school here from another database</source>
        <translation>別のデータベースから学校をここへ移した</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>無効</translation>
    </message>
    <message>
        <source>enabled</source>
        <translation>有効</translation>
    </message>
    <message numerus="yes">
        <source>at most %n attempt(s)</source>
        <translation>
            <numerusform>試行は%n回まで</numerusform>
        </translation>
    </message>
    <message>
        <source>as many attempts as one likes</source>
        <translation>試行回数に制限なし</translation>
    </message>
    <message>
        <source>It has more fields than the first line names.</source>
        <translation>1行目の列より項目が多くあります。</translation>
    </message>
    <message>
        <source>It stands in line %1 already.</source>
        <translation>すでに%1行目にあります。</translation>
    </message>
    <message>
        <source>It is too long, or has signs that cannot be seen.</source>
        <translation>長すぎるか、見えない文字を含んでいます。</translation>
    </message>
    <message>
        <source>It is none of student, instructor, admin.</source>
        <translation>student、instructor、admin のいずれでもありません。</translation>
    </message>
    <message>
        <source>Here the role is %1; a class list does not change it.</source>
        <translation>ここでの役割は%1です。名簿では変更されません。</translation>
    </message>
    <message>
        <source>The name of a class has 1 to 100 characters that can be seen.</source>
        <translation>クラス名は見える文字で1～100文字です。</translation>
    </message>
    <message>
        <source>when a place that was left is locked</source>
        <translation>離席後にロックするまでの時間</translation>
    </message>
    <message>
        <source>how long checking a password takes</source>
        <translation>パスワードの確認にかかる時間</translation>
    </message>
    <message>
        <source>how much memory checking a password takes</source>
        <translation>パスワードの確認に使うメモリ</translation>
    </message>
    <message>
        <source>the preset that everybody uses</source>
        <translation>全員が使うプリセット</translation>
    </message>
    <message>
        <source>attempt %1</source>
        <translation>試行 %1</translation>
    </message>
    <message>
        <source>exam %1</source>
        <translation>試験 %1</translation>
    </message>
    <message>
        <source>class %1</source>
        <translation>クラス %1</translation>
    </message>
    <message>
        <source>person %1</source>
        <translation>人物 %1</translation>
    </message>
    <message>
        <source>setting %1</source>
        <translation>設定 %1</translation>
    </message>
    <message>
        <source>all attempts</source>
        <translation>すべての試行</translation>
    </message>
    <message>
        <source>the school</source>
        <translation>学校</translation>
    </message>
    <message>
        <source>the audit</source>
        <translation>監査記録</translation>
    </message>
    <message>
        <source>preset %1, version %2</source>
        <translation>プリセット「%1」バージョン %2</translation>
    </message>
    <message>
        <source>backup of %1</source>
        <extracomment>%1: a day and a time, or the name of a file</extracomment>
        <translation>%1 のバックアップ</translation>
    </message>
    <message>
        <source>From sign %1 of this line on the file is no UTF-8 text. Save it from the spreadsheet as “CSV UTF-8”.</source>
        <translation>この行の%1文字目からUTF-8のテキストではありません。表計算ソフトで「CSV UTF-8」として保存してください。</translation>
    </message>
    <message>
        <source>A quotation mark at sign %1 of this line is not closed.</source>
        <translation>この行の%1文字目の引用符が閉じられていません。</translation>
    </message>
    <message>
        <source>At sign %1 of this line words stand behind a closing quotation mark.</source>
        <translation>この行の%1文字目で、閉じ引用符の後に文字があります。</translation>
    </message>
    <message>
        <source>A class list has no such column. Is it %1?</source>
        <extracomment>%1: the name of a column</extracomment>
        <translation>クラス名簿にこの列はありません。%1 のことですか。</translation>
    </message>
    <message>
        <source>This column is there twice.</source>
        <translation>この列が2つあります。</translation>
    </message>
    <message>
        <source>This column is missing. The first line names the columns.</source>
        <translation>この列がありません。最初の行に列名を書きます。</translation>
    </message>
    <message>
        <source>a computer wrote here for the first time</source>
        <translation>コンピューターが初めて書き込みました</translation>
    </message>
    <message>
        <source>computer with the key %1</source>
        <translation>鍵 %1 のコンピューター</translation>
    </message>
    <message>
        <source>took out a report of a class</source>
        <translation>クラスの報告書を取り出しました</translation>
    </message>
    <message>
        <source>had the password kept more safely</source>
        <translation>パスワードがより安全に保存されました</translation>
    </message>
    <message>
        <source>took a comment back</source>
        <translation>コメントを取り下げました</translation>
    </message>
    <message>
        <source>how long a login by a name that nobody has takes</source>
        <translation>存在しない名前でのログインにかかる時間</translation>
    </message>
    <message>
        <source>A class list has no such column. It has username, given_name, family_name, role and class.</source>
        <translation>クラス名簿にこの列はありません。列は username、given_name、family_name、role、class です。</translation>
    </message>
    <message>
        <source>which presets are retired</source>
        <translation>使わないプリセット</translation>
    </message>
    <message>
        <source>table %1</source>
        <translation>テーブル %1</translation>
    </message>
    <message>
        <source>trigger %1</source>
        <translation>トリガー %1</translation>
    </message>
    <message>
        <source>It is empty, longer than 64 characters, or has other characters than the letters a to z, digits and . _ - @.</source>
        <translation>空であるか、64文字を超えているか、英字a〜z、数字、. _ - @ 以外の文字が含まれています。</translation>
    </message>
</context>
<context>
    <name>Block</name>
    <message>
        <source>Practice block: line</source>
        <translation>練習ブロック：直線</translation>
    </message>
    <message>
        <source>Practice block: circle</source>
        <translation>練習ブロック：円</translation>
    </message>
    <message>
        <source>Practice block: cross</source>
        <translation>練習ブロック：十字</translation>
    </message>
    <message>
        <source>Practice block: square</source>
        <translation>練習ブロック：正方形</translation>
    </message>
    <message>
        <source>Practice block: dovetail</source>
        <translation>練習ブロック：鳩尾形</translation>
    </message>
    <message>
        <source>Practice block: staircase</source>
        <translation>練習ブロック：階段</translation>
    </message>
    <message>
        <source>Practice block: letter I</source>
        <translation>練習ブロック：I字</translation>
    </message>
    <message>
        <source>Practice block: letter T</source>
        <translation>練習ブロック：T字</translation>
    </message>
    <message>
        <source>Practice block: three layers</source>
        <translation>練習ブロック：3層</translation>
    </message>
    <message>
        <source>Practice block: depth plunges</source>
        <translation>練習用ブロック：深さ別の穴</translation>
    </message>
    <message>
        <source>Practice block: enamel and dentin</source>
        <translation>練習用ブロック：エナメル質と象牙質</translation>
    </message>
</context>
<context>
    <name>Breach</name>
    <message>
        <source>The pulp is exposed</source>
        <translation>歯髄が露出しています</translation>
    </message>
    <message>
        <source>The tooth is perforated</source>
        <translation>歯に穿孔があります</translation>
    </message>
    <message>
        <source>Deeper than %1 mm</source>
        <translation>%1 mmより深くなっています</translation>
    </message>
    <message>
        <source>The marginal ridge is thinner than %1 mm</source>
        <translation>辺縁隆線が%1 mmより薄くなっています</translation>
    </message>
    <message>
        <source>Cut outside the target area</source>
        <translation>目標の範囲外を切削しました</translation>
    </message>
    <message>
        <source>Pressed with %1 N; the limit is %2 N</source>
        <translation>%1 Nで押しました。許容は%2 Nです</translation>
    </message>
    <message>
        <source>The bur ran without contact for %1 s</source>
        <translation>バーが%1秒空転しました</translation>
    </message>
    <message>
        <source>The running bur touched the adjacent tooth</source>
        <translation>回転中のバーが隣在歯に触れました</translation>
    </message>
    <message>
        <source>Cut with a bur that this lesson does not allow</source>
        <translation>この課題で使えないバーで切削しました</translation>
    </message>
    <message>
        <source>An exposed pulp usually dies, because cut odontoblasts do not recover. Watch the section and leave half a millimetre of dentin.</source>
        <translation>露髄した歯髄の多くは失活します。切断された象牙芽細胞は回復しません。断面を見て、象牙質を0.5 mm残してください。</translation>
    </message>
    <message>
        <source>A perforated tooth is usually lost. Watch the depth in the section.</source>
        <translation>穿孔した歯の多くは保存できません。断面で深さに注意してください。</translation>
    </message>
    <message>
        <source>Cutting deeper than necessary weakens the tooth and comes close to the pulp. The section shows how deep you are.</source>
        <translation>必要以上に深い切削は歯を弱め、歯髄に近づきます。断面で深さを確認できます。</translation>
    </message>
    <message>
        <source>A thin marginal ridge breaks under load. Stop the bur&apos;s outer edge earlier.</source>
        <translation>薄い辺縁隆線は荷重で破折します。バーの外側の縁をもっと手前で止めてください。</translation>
    </message>
    <message>
        <source>Sound tissue does not grow back. The dashed line in the section shows what to cut.</source>
        <translation>健全な歯質は再生しません。断面の破線が切削すべき範囲を示します。</translation>
    </message>
    <message>
        <source>About 1 N cuts best; more heats the pulp, stalls the turbine and slips. Let the bur do the work.</source>
        <translation>およそ1 Nが最もよく切れます。それ以上では歯髄が発熱し、タービンが止まり、滑ります。切削はバーに任せてください。</translation>
    </message>
    <message>
        <source>A running bur can injure lips and cheeks. Stop it when you are not cutting.</source>
        <translation>回転中のバーは唇や頬を傷つけることがあります。切削しないときは止めてください。</translation>
    </message>
    <message>
        <source>A nick in the adjacent tooth collects plaque and decays. Stay inside the outline; N shows the adjacent teeth.</source>
        <translation>隣在歯の傷にはプラークがたまり、う蝕になります。外形線の内側で作業してください。Nで隣在歯が表示されます。</translation>
    </message>
    <message>
        <source>The shape of the bur determines the shape of the cavity. Choose a bur that the lesson lists.</source>
        <translation>形の違うバーでは窩洞の形も変わります。課題で指定されたバーを選んでください。</translation>
    </message>
</context>
<context>
    <name>Bur</name>
    <message>
        <source>Round, No. %1</source>
        <translation>ラウンド、No. %1</translation>
    </message>
    <message>
        <source>Inverted cone, No. %1</source>
        <translation>インバーテッドコーン、No. %1</translation>
    </message>
    <message>
        <source>Straight fissure, No. %1</source>
        <translation>ストレートフィッシャー、No. %1</translation>
    </message>
    <message>
        <source>Straight fissure, crosscut, No. %1</source>
        <translation>クロスカットのストレートフィッシャー、No. %1</translation>
    </message>
    <message>
        <source>Domed fissure, crosscut, No. %1</source>
        <translation>クロスカットのドーム型フィッシャー、No. %1</translation>
    </message>
    <message>
        <source>Tapered fissure, No. %1</source>
        <translation>テーパーフィッシャー、No. %1</translation>
    </message>
    <message>
        <source>Tapered fissure, crosscut, No. %1</source>
        <translation>クロスカットのテーパーフィッシャー、No. %1</translation>
    </message>
    <message>
        <source>Pear, No. %1</source>
        <translation>ペアー、No. %1</translation>
    </message>
    <message>
        <source>Long pear, No. %1</source>
        <translation>ロングペアー、No. %1</translation>
    </message>
    <message>
        <source>Egg, No. %1</source>
        <translation>エッグ、No. %1</translation>
    </message>
    <message>
        <source>Flame, No. %1</source>
        <translation>フレーム、No. %1</translation>
    </message>
    <message>
        <source>Cylinder, No. %1</source>
        <translation>シリンダー、No. %1</translation>
    </message>
    <message>
        <source>Round-end taper, No. %1</source>
        <translation>ラウンドエンドテーパー、No. %1</translation>
    </message>
    <message>
        <source>Chamfer, No. %1</source>
        <translation>シャンファー、No. %1</translation>
    </message>
    <message>
        <source>Diamond, round, No. %1</source>
        <translation>ダイヤモンド・ラウンド、No. %1</translation>
    </message>
    <message>
        <source>Diamond, pear, No. %1</source>
        <translation>ダイヤモンド・ペアー、No. %1</translation>
    </message>
    <message>
        <source>Diamond, egg, No. %1</source>
        <translation>ダイヤモンド・エッグ、No. %1</translation>
    </message>
    <message>
        <source>Diamond, flame, No. %1</source>
        <translation>ダイヤモンド・フレーム、No. %1</translation>
    </message>
    <message>
        <source>Diamond, cylinder, No. %1</source>
        <translation>ダイヤモンド・シリンダー、No. %1</translation>
    </message>
    <message>
        <source>Diamond, round-end taper, No. %1</source>
        <translation>ダイヤモンド・ラウンドエンドテーパー、No. %1</translation>
    </message>
    <message>
        <source>Diamond, chamfer, No. %1</source>
        <translation>ダイヤモンド・シャンファー、No. %1</translation>
    </message>
    <message>
        <source>Diamond, No. %1</source>
        <translation>ダイヤモンド、No. %1</translation>
    </message>
</context>
<context>
    <name>Chart</name>
    <message numerus="yes">
        <source>and %n more</source>
        <extracomment>Bars of a chart that there is no room for</extracomment>
        <translation>
            <numerusform>ほか%n件</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Criterion</name>
    <message>
        <source>%1 of the decay is removed</source>
        <extracomment>%1: a share: &quot;50 %&quot;</extracomment>
        <translation>う蝕の%1の除去</translation>
    </message>
    <message>
        <source>%1 of the ideal is cut</source>
        <translation>理想形の%1の切削</translation>
    </message>
    <message>
        <source>%1 of the shape is cut</source>
        <translation>形の%1の切削</translation>
    </message>
    <message>
        <source>%1 has reached %2</source>
        <extracomment>%1: the name of a measure, %2: a figure with its unit</extracomment>
        <translation>%1の%2への到達</translation>
    </message>
    <message>
        <source>Enamel and dentin beside and below the decay. Tissue directly above the decay must be removed and is not counted.</source>
        <translation>う蝕の横と下にあるエナメル質と象牙質です。う蝕の真上は除去が必要なので数えません。</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>測定なし</translation>
    </message>
    <message>
        <source>%1 − %2 free</source>
        <extracomment>%1 is a value, %2 what of it costs nothing: &quot;3.20 − 1.00 free&quot;</extracomment>
        <translation>%1 − %2 許容</translation>
    </message>
    <message>
        <source>at least %1 %2</source>
        <translation>%1 %2以上</translation>
    </message>
    <message>
        <source>up to %1 %2</source>
        <translation>%1 %2まで</translation>
    </message>
    <message>
        <source>None of its %1 points are earned before %2</source>
        <extracomment>%1: points of a score, %2: what has to be done: &quot;50 % of the decay is removed&quot;</extracomment>
        <translation>%2までは%1点のうち何も得られません</translation>
    </message>
    <message>
        <source>Not measured, so the attempt fails and the remaining %1 points are lost</source>
        <translation>測定されなかったため不合格となり、残りの%1点を失います</translation>
    </message>
    <message>
        <source>Not measured, so it earns none of its %1 points</source>
        <translation>測定されなかったため、%1点は得られません</translation>
    </message>
    <message>
        <source>%1: nothing lost</source>
        <translation>%1：減点なし</translation>
    </message>
    <message>
        <source>Allowed: %1. The attempt fails and the remaining %2 points are lost</source>
        <extracomment>%1 is a range: &quot;up to 0.00 mm²&quot;</extracomment>
        <translation>許容は%1です。超えると不合格となり、残りの%2点を失います</translation>
    </message>
    <message>
        <source>%1 %2 outside the limit; a more serious error decides</source>
        <translation>%1 %2の超過。より重い誤りで決まります</translation>
    </message>
    <message>
        <source>%1; beyond it all of its %2 points are lost</source>
        <translation>%1。超えると%2点すべてを失います</translation>
    </message>
    <message>
        <source>(%1) / %2 %3 × %4 points</source>
        <translation>(%1) / %2 %3 × %4点</translation>
    </message>
    <message>
        <source>%1, at most all of them</source>
        <translation>%1、ただし全点まで</translation>
    </message>
    <message>
        <source>The measured value was not saved</source>
        <translation>測定した値は保存されていません</translation>
    </message>
    <message>
        <source>Counts as soon as %1</source>
        <extracomment>%1: what has to be done: &quot;50 % of the decay is removed&quot;</extracomment>
        <translation>%1以降に判定されます</translation>
    </message>
    <message>
        <source>Not measured, so the score is limited to %1 points</source>
        <extracomment>%1: points of a score</extracomment>
        <translation>測定されていないため、得点は最大%1点です</translation>
    </message>
    <message>
        <source>Allowed: %1. The score is limited to %2 points</source>
        <extracomment>%1 is a range: &quot;up to 0.00 mm²&quot;; %2: points of a score</extracomment>
        <translation>許容：%1。得点は最大%2点です</translation>
    </message>
    <message>
        <source>%1 of the tooth is removed</source>
        <translation>歯の%1の除去</translation>
    </message>
</context>
<context>
    <name>Direction</name>
    <message>
        <source>distal</source>
        <translation>遠心</translation>
    </message>
    <message>
        <source>mesial</source>
        <translation>近心</translation>
    </message>
    <message>
        <source>labial</source>
        <translation>唇側</translation>
    </message>
    <message>
        <source>buccal</source>
        <translation>頬側</translation>
    </message>
    <message>
        <source>palatal</source>
        <translation>口蓋側</translation>
    </message>
    <message>
        <source>lingual</source>
        <translation>舌側</translation>
    </message>
    <message>
        <source>distolabial</source>
        <translation>遠心唇側</translation>
    </message>
    <message>
        <source>distobuccal</source>
        <translation>遠心頬側</translation>
    </message>
    <message>
        <source>distopalatal</source>
        <translation>遠心口蓋側</translation>
    </message>
    <message>
        <source>distolingual</source>
        <translation>遠心舌側</translation>
    </message>
    <message>
        <source>mesiolabial</source>
        <translation>近心唇側</translation>
    </message>
    <message>
        <source>mesiobuccal</source>
        <translation>近心頬側</translation>
    </message>
    <message>
        <source>mesiopalatal</source>
        <translation>近心口蓋側</translation>
    </message>
    <message>
        <source>mesiolingual</source>
        <translation>近心舌側</translation>
    </message>
    <message>
        <source>Mesio-distal</source>
        <translation>近遠心</translation>
    </message>
    <message>
        <source>Along x</source>
        <translation>x方向</translation>
    </message>
    <message>
        <source>Along y</source>
        <translation>y方向</translation>
    </message>
    <message>
        <source>Labio-palatal</source>
        <translation>唇口蓋</translation>
    </message>
    <message>
        <source>Labio-lingual</source>
        <translation>唇舌</translation>
    </message>
    <message>
        <source>Bucco-palatal</source>
        <translation>頬口蓋</translation>
    </message>
    <message>
        <source>Bucco-lingual</source>
        <translation>頬舌</translation>
    </message>
    <message>
        <source>apical</source>
        <translation>根尖側</translation>
    </message>
    <message>
        <source>incisal</source>
        <translation>切縁側</translation>
    </message>
    <message>
        <source>occlusal</source>
        <translation>咬合面側</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <extracomment>Two directions at once, such as &quot;mesial / incisal&quot;</extracomment>
        <translation>%1・%2</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>Export it again, or choose another scan.</source>
        <translation>もう一度書き出すか、別のスキャンを選んでください。</translation>
    </message>
    <message>
        <source>Copy it again from where it was made, or choose another one.</source>
        <translation>作成元からもう一度コピーするか、別のものを選んでください。</translation>
    </message>
    <message>
        <source>Put a copy of it back, or move it away: Cusp then begins a new one.</source>
        <translation>コピーを元に戻すか、移動してください。その場合Cuspは新しく作り直します。</translation>
    </message>
    <message>
        <source>Its file is kept for seven days, in the folder &quot;discarded&quot;.</source>
        <translation>そのファイルは「discarded」フォルダーに7日間保管されます。</translation>
    </message>
    <message>
        <source>Ask who made the lesson, or choose another one.</source>
        <translation>課題の作成者に問い合わせるか、別のものを選んでください。</translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation>もう一度お試しください。</translation>
    </message>
    <message>
        <source>The file is no recording of Cusp.</source>
        <translation>このファイルはCuspの記録ではありません。</translation>
    </message>
    <message>
        <source>The file is no database of Cusp.</source>
        <translation>このファイルはCuspのデータベースではありません。</translation>
    </message>
    <message>
        <source>This Cusp did not write the file, or an older one did.</source>
        <translation>このファイルは、このCuspが書いたものではないか、古いCuspのものです。</translation>
    </message>
    <message>
        <source>The file is not what its name says. Scans are OBJ, STL or PLY.</source>
        <translation>ファイルの中身が名前と一致しません。スキャンはOBJ、STL、PLYのいずれかです。</translation>
    </message>
    <message>
        <source>The file is not there. Was it moved or renamed?</source>
        <translation>ファイルがありません。移動または名前を変更しましたか？</translation>
    </message>
    <message>
        <source>The file cannot be read. Check that it is a file and that you may open it.</source>
        <translation>ファイルを読み取れません。ファイルであること、開く権限があることを確認してください。</translation>
    </message>
    <message>
        <source>The file cannot be written. Choose another folder, or make room on the disk.</source>
        <translation>ファイルに書き込めません。別のフォルダーを選ぶか、ディスクの空きを増やしてください。</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>ファイルが空です。</translation>
    </message>
    <message>
        <source>The file ends too early.</source>
        <translation>ファイルが途中で終わっています。</translation>
    </message>
    <message>
        <source>The file is too large. Export it with fewer triangles.</source>
        <translation>ファイルが大きすぎます。三角形を減らして書き出してください。</translation>
    </message>
    <message>
        <source>The file is too large.</source>
        <translation>ファイルが大きすぎます。</translation>
    </message>
    <message>
        <source>A newer Cusp wrote this file. Update Cusp to open it.</source>
        <translation>このファイルは新しいCuspで書かれました。Cuspを更新してから開いてください。</translation>
    </message>
    <message>
        <source>Where a number belongs, the file holds something else.</source>
        <translation>数値があるべき場所に別のものがあります。</translation>
    </message>
    <message>
        <source>The content of the file does not fit together.</source>
        <translation>ファイルの内容に矛盾があります。</translation>
    </message>
    <message>
        <source>There is no surface in this file. Choose a scan of a tooth.</source>
        <translation>このファイルには表面がありません。歯のスキャンを選んでください。</translation>
    </message>
    <message>
        <source>Cusp does not know what is asked for by this name.</source>
        <translation>この名前で求められたものをCuspは知りません。</translation>
    </message>
    <message>
        <source>A value lies outside what Cusp can work with.</source>
        <translation>Cuspが扱える範囲を超えた値があります。</translation>
    </message>
    <message>
        <source>It was made on another tooth, or with another decay, than this lesson&apos;s. Ask who made the lesson.</source>
        <translation>この課題とは別の歯、または別のう蝕で作られています。課題の作成者に問い合わせてください。</translation>
    </message>
    <message>
        <source>Another program is writing to the school&apos;s database. Try again in a moment.</source>
        <translation>別のプログラムが学校のデータベースに書き込み中です。少し待ってからもう一度お試しください。</translation>
    </message>
    <message>
        <source>The school&apos;s server does not answer. Cusp tries again by itself.</source>
        <translation>学校のサーバーが応答しません。Cuspが自動的に再試行します。</translation>
    </message>
    <message>
        <source>Your role does not allow it.</source>
        <translation>あなたの権限では許可されていません。</translation>
    </message>
    <message>
        <source>Wrong username or password.</source>
        <translation>ユーザー名またはパスワードが違います。</translation>
    </message>
    <message>
        <source>Too many logins have failed. Wait a moment and try again.</source>
        <translation>ログインの失敗が多すぎます。少し待ってからもう一度お試しください。</translation>
    </message>
    <message>
        <source>Choose a password first.</source>
        <translation>先にパスワードを設定してください。</translation>
    </message>
    <message>
        <source>The scan cannot be opened. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>スキャンを開けません。%1</translation>
    </message>
    <message>
        <source>The tooth cannot be created. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>歯を作れません。%1</translation>
    </message>
    <message>
        <source>The lesson cannot be started; your work is unchanged. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>この課題は開始できません。これまでの歯はそのまま残っています。%1</translation>
    </message>
    <message>
        <source>The work cannot be graded; it is unchanged. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>採点できません。作業内容はそのままです。%1</translation>
    </message>
    <message>
        <source>The recording cannot be played. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>記録を再生できません。%1</translation>
    </message>
    <message>
        <source>The recording was not saved. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>記録は保存されませんでした。%1</translation>
    </message>
    <message>
        <source>Nothing has been cut yet that could be a reference.</source>
        <translation>基準にできる切削がまだありません。</translation>
    </message>
    <message>
        <source>The reference was not saved. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>基準は保存されませんでした。%1</translation>
    </message>
    <message>
        <source>Grades will not be saved; drilling and grading still work. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>成績は保存されませんが、切削と採点はこれまでどおり使えます。%1</translation>
    </message>
    <message>
        <source>This attempt is not kept on the disk while you work: if the computer fails, it is lost. Make room on the disk, or save the recording now and then.</source>
        <translation>作業中、この試行はディスクに保存されません。コンピューターが故障すると失われます。ディスクの空きを増やすか、ときどき記録を保存してください。</translation>
    </message>
    <message>
        <source>This attempt is not kept on the disk while you work. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>作業中、この試行はディスクに保存されません。%1</translation>
    </message>
    <message>
        <source>An unfinished attempt cannot be resumed. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>未完了の試行を再開できません。%1</translation>
    </message>
    <message>
        <source>The school&apos;s data cannot be shown now; your work is saved. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>学校の保管データは今表示できませんが、あなたの作業は保存されます。%1</translation>
    </message>
    <message>
        <source>The school&apos;s file cannot be written. Make room on the disk, or make its folder writable.</source>
        <translation>学校のファイルに書き込めません。ディスクの空きを増やすか、フォルダーを書き込み可能にしてください。</translation>
    </message>
    <message>
        <source>An older Cusp made this school. Ask its administrator to run “cusp db migrate”.</source>
        <translation>この学校は古い Cusp で作られました。管理者に移行（cusp の「db migrate」）を依頼してください。</translation>
    </message>
    <message>
        <source>That was not done, and nothing was changed. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>実行されませんでした。何も変更されていません。%1</translation>
    </message>
    <message>
        <source>An attempt that was to be sent to the school is damaged. It was moved to the folder “outbox/damaged”. Everything else is saved as usual.</source>
        <translation>学校へ送る試行が壊れているため、フォルダー「outbox/damaged」に移しました。ほかはこれまでどおり保存されます。</translation>
    </message>
    <message>
        <source>Somebody else has changed it meanwhile. Here is what there is now; change it again if need be.</source>
        <translation>その間にほかの人が変更しました。現在の内容を表示しています。必要ならもう一度変更してください。</translation>
    </message>
    <message>
        <source>This is the last admin who can log in. Make somebody else an admin first.</source>
        <translation>ログインできる最後の管理者です。先にほかの人を管理者にしてください。</translation>
    </message>
    <message>
        <source>This account was disabled. Ask an admin.</source>
        <translation>このアカウントは無効にされました。管理者に尋ねてください。</translation>
    </message>
    <message>
        <source>The school&apos;s server does not answer. Try it again when the server answers.</source>
        <translation>学校のサーバーが応答しません。サーバーが応答するようになったら、もう一度お試しください。</translation>
    </message>
    <message>
        <source>This grade is not saved yet; Cusp tries again while it runs. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>この評価はまだ保存されていません。Cuspの起動中はもう一度試み続けます。%1</translation>
    </message>
    <message>
        <source>The folder “outbox”, where grades wait for the school, cannot be written. Make room on the disk, or make that folder writable.</source>
        <translation>成績が学校へ送られるのを待つフォルダー「outbox」に書き込めません。ディスクの空きを作るか、そのフォルダーを書き込み可能にしてください。</translation>
    </message>
    <message>
        <source>This attempt is not kept on the disk while you work: if the computer fails, it is lost. Go on, and have room made on the disk.</source>
        <translation>この試行は作業中にディスクに保存されていません。コンピューターが止まると失われます。作業を続け、ディスクの空きを作ってもらってください。</translation>
    </message>
    <message>
        <source>The school&apos;s data lie on a network drive, and another Cusp, here or at another computer, has them open. Only one at a time can: close that one. For several computers an admin keeps them on a PostgreSQL server.</source>
        <translation>学校のデータはネットワークドライブにあり、このコンピューターまたは別のコンピューターの別のCuspが開いています。同時に使えるのは1つだけです。そちらを閉じてください。複数のコンピューターで使うには、管理者がPostgreSQLサーバーに置きます。</translation>
    </message>
    <message>
        <source>The school&apos;s server says no. Ask whoever looks after it: its log, or “cusp db check”, says why.</source>
        <translation>学校のサーバーに拒否されました。サーバーの担当者に問い合わせてください。理由はサーバーのログか、cusp の「db check」でわかります。</translation>
    </message>
    <message>
        <source>The school&apos;s server cannot prove that it is the right one, or cannot encrypt the connection, so nothing is sent to it. Ask whoever looks after it to set up its certificate.</source>
        <translation>学校のサーバーは、本物であることを証明できないか、接続を暗号化できません。そのため何も送信しません。サーバーの管理者に、証明書の設定を頼んでください。</translation>
    </message>
    <message>
        <source>Your login has ended, or another school is now where yours was. Log in again.</source>
        <translation>ログインが終了したか、この学校のあった場所に別の学校があります。もう一度ログインしてください。</translation>
    </message>
    <message>
        <source>The school&apos;s server went away while this was being done, and nobody can say whether it was. Look when it answers again, before you do it again.</source>
        <translation>この処理の途中で学校のサーバーとの接続が切れました。実行されたかどうかは分かりません。もう一度行う前に、サーバーが応答するようになったら確認してください。</translation>
    </message>
    <message>
        <source>Nothing was written: what stands on it is read anew for it. %1</source>
        <extracomment>%1: why, and what to do</extracomment>
        <translation>何も書き出されませんでした。書き出す内容はそのつど読み直されます。%1</translation>
    </message>
</context>
<context>
    <name>ExamWords</name>
    <message>
        <source>undo</source>
        <translation>取り消し</translation>
    </message>
    <message>
        <source>expert&apos;s attempt</source>
        <translation>エキスパートの試行</translation>
    </message>
    <message>
        <source>earlier attempts</source>
        <translation>以前の試行</translation>
    </message>
    <message>
        <source>Time: %1</source>
        <extracomment>%1: &quot;8 min&quot;, or that there is no limit</extracomment>
        <translation>時間：%1</translation>
    </message>
    <message>
        <source>Attempts: %1</source>
        <extracomment>%1: &quot;2 attempts left, 1 graded so far&quot;</extracomment>
        <translation>試行：%1</translation>
    </message>
    <message>
        <source>Passed from: %1 of 100 points</source>
        <extracomment>%1: points</extracomment>
        <translation>合格：100点中%1点以上</translation>
    </message>
    <message>
        <source>Locked: %1</source>
        <extracomment>%1: a list</extracomment>
        <translation>使用不可：%1</translation>
    </message>
    <message>
        <source>The clock starts when you begin, and also runs while you are on another page. Faults are shown after the grade.</source>
        <translation>時計は開始と同時に動き、ほかのページを開いている間も止まりません。誤りは採点のあとに表示されます。</translation>
    </message>
    <message>
        <source>&amp;Begin exam</source>
        <translation>試験を開始(&amp;B)</translation>
    </message>
</context>
<context>
    <name>ExerciseMarks</name>
    <message>
        <source>height, mm</source>
        <extracomment>Title of a scale: how high the bur&apos;s tip stands over the block</extracomment>
        <translation>高さ、mm</translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>&quot;%1&quot; has changed since the lesson was read; open the page again.</source>
        <translation>「%1」は課題を読み込んだ後に変更されました。ページを開き直してください。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read, or has more than %2 MB, which a lesson may take along; use a coarser scan.</source>
        <translation>「%1」は読み込めないか、課題に含められる%2 MBを超えています。より粗いスキャンを使ってください。</translation>
    </message>
    <message>
        <source>The version that was assigned is not on this computer yet. Open this page again when the database can be reached.</source>
        <translation>課された版はまだこのコンピューターにありません。データベースに接続できるときにこのページを開き直してください。</translation>
    </message>
    <message>
        <source>The version that was assigned cannot be read by this version of Cusp. Ask who keeps Cusp to update it.</source>
        <translation>このCuspでは課された版を読み込めません。管理者にCuspの更新を依頼してください。</translation>
    </message>
    <message>
        <source>touch.points[%1]: there is no tooth at x = %2, y = %3 mm</source>
        <translation>touch.points[%1]：x = %2、y = %3 mmに歯がありません</translation>
    </message>
    <message>
        <source>has %1; a lesson has at most %2</source>
        <translation>%1あります。課題は%2までです</translation>
    </message>
    <message>
        <source>unterminated object</source>
        <translation>オブジェクトが閉じられていません</translation>
    </message>
    <message>
        <source>missing name separator</source>
        <translation>キーの後のコロンがありません</translation>
    </message>
    <message>
        <source>unterminated array</source>
        <translation>リストが閉じられていません</translation>
    </message>
    <message>
        <source>missing value separator</source>
        <translation>値と値の間のコンマがありません</translation>
    </message>
    <message>
        <source>invalid termination by number</source>
        <translation>最後の数値の後が欠けています</translation>
    </message>
    <message>
        <source>illegal number</source>
        <translation>数値が正しくありません</translation>
    </message>
    <message>
        <source>invalid escape sequence</source>
        <translation>\の後の文字が正しくありません</translation>
    </message>
    <message>
        <source>unterminated string</source>
        <translation>文字列が閉じられていません</translation>
    </message>
    <message>
        <source>object is missing after a comma</source>
        <translation>コンマの後が欠けています</translation>
    </message>
    <message>
        <source>too deeply nested document</source>
        <translation>入れ子が深すぎます</translation>
    </message>
    <message>
        <source>too large document</source>
        <translation>大きすぎます</translation>
    </message>
    <message>
        <source>garbage at the end of the document</source>
        <translation>末尾に余分なものがあります</translation>
    </message>
    <message>
        <source>illegal value</source>
        <translation>値が正しくありません</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1バイト</translation>
    </message>
    <message>
        <source>is %1, from a newer Cusp; this one reads %2. Update Cusp to give this lesson</source>
        <translation>%1で、新しいCuspのものです。このCuspが読めるのは%2です。この課題を使うにはCuspを更新してください</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>空です</translation>
    </message>
    <message>
        <source>is written in UTF-16 or UTF-32; save it as UTF-8</source>
        <translation>UTF-16かUTF-32で書かれています。UTF-8で保存してください</translation>
    </message>
    <message>
        <source>is not JSON: line %1, column %2: invalid UTF8 string; save the file as UTF-8</source>
        <translation>JSONではありません。%1行%2列目：文字列がUTF-8ではありません。UTF-8で保存してください</translation>
    </message>
    <message>
        <source>is not JSON: line %1, column %2: %3</source>
        <translation>JSONではありません。%1行%2列目：%3</translation>
    </message>
    <message>
        <source>must be one JSON object in braces</source>
        <translation>波括弧で囲んだ1つのJSONオブジェクトでなければなりません</translation>
    </message>
    <message>
        <source>is said twice in one object; leave one out</source>
        <translation>1つのオブジェクトに2回書かれています。1つ消してください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; leads out of the lesson&apos;s folder; name a file beside it</source>
        <translation>「%1」は課題のフォルダーの外を指しています。同じ場所にあるファイルを指定してください</translation>
    </message>
    <message>
        <source>is based on itself by way of %1</source>
        <translation>%1を経て自分自身に基づいています</translation>
    </message>
    <message>
        <source>more than %1 files are based on one another</source>
        <translation>%1個を超えるファイルが互いに基づいています</translation>
    </message>
    <message>
        <source>must be the name of a file beside this one, or of one that is shipped</source>
        <translation>同じ場所にあるファイルか、付属のファイルの名前でなければなりません</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>存在しません</translation>
    </message>
    <message>
        <source>cannot be read (it is a folder)</source>
        <translation>読み取れません（フォルダーです）</translation>
    </message>
    <message>
        <source>cannot be read (it is no file)</source>
        <translation>読み取れません（ファイルではありません）</translation>
    </message>
    <message>
        <source>cannot be read (%1)</source>
        <translation>読み取れません（%1）</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>trueかfalse</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文字列</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>オブジェクト</translation>
    </message>
    <message>
        <source>null</source>
        <translation>null</translation>
    </message>
    <message>
        <source>is %1; write a number of %2 without its unit</source>
        <translation>%1です。単位（%2）を付けずに数値を書いてください</translation>
    </message>
    <message>
        <source>is %1; write a number</source>
        <translation>%1です。数値を書いてください</translation>
    </message>
    <message>
        <source>is %1, it must lie between %2 and %3 %4</source>
        <translation>%1ですが、%2から%3 %4まででなければなりません</translation>
    </message>
    <message>
        <source>is %1, it must lie between %2 and %3</source>
        <translation>%1ですが、%2から%3まででなければなりません</translation>
    </message>
    <message>
        <source>is %1, it must be a whole number</source>
        <translation>%1ですが、整数でなければなりません</translation>
    </message>
    <message>
        <source>is %1; write true or false</source>
        <translation>%1です。trueかfalseと書いてください</translation>
    </message>
    <message>
        <source>is %1; write a text in quotes</source>
        <translation>%1です。引用符で囲んだ文字列を書いてください</translation>
    </message>
    <message>
        <source>has %1 characters; at most %2 are read</source>
        <translation>%1文字あります。読めるのは%2文字までです</translation>
    </message>
    <message>
        <source>holds the character U+%1, which cannot be seen; leave it out</source>
        <translation>見えない文字U+%1を含んでいます。取り除いてください</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>ありません</translation>
    </message>
    <message>
        <source>has %1 characters; it takes 1 to %2</source>
        <translation>%1文字あります。1～%2文字にしてください</translation>
    </message>
    <message>
        <source>is %1; write {&quot;en&quot;: &quot;...&quot;, &quot;de&quot;: &quot;...&quot;}</source>
        <translation>%1です。{&quot;en&quot;: &quot;...&quot;, &quot;de&quot;: &quot;...&quot;} のように書いてください</translation>
    </message>
    <message>
        <source>has texts in %1 languages; it takes 1 to %2</source>
        <translation>%1言語の文があります。1～%2言語にしてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; must be the code of a language (en, de, es, ja) with a text</source>
        <translation>「%1」は言語コード（en、de、es、ja）と文字列でなければなりません</translation>
    </message>
    <message>
        <source>must be a list of at most %1 texts: [&quot;...&quot;, &quot;...&quot;]</source>
        <translation>%1個までの文字列のリストでなければなりません：[&quot;...&quot;, &quot;...&quot;]</translation>
    </message>
    <message>
        <source>is %1; write an object in braces</source>
        <translation>%1です。波括弧で囲んだオブジェクトを書いてください</translation>
    </message>
    <message>
        <source>must be a list of at most %1 objects</source>
        <translation>%1個までのオブジェクトのリストでなければなりません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known; there are %2</source>
        <translation>「%1」は使えません。使えるもの：%2</translation>
    </message>
    <message>
        <source>must be a list of 1 to %1 places: [[x, y], ...]</source>
        <translation>1～%1か所のリストでなければなりません：[[x, y], ...]</translation>
    </message>
    <message>
        <source>must be [x, y], two numbers between %1 and %2 mm</source>
        <translation>[x, y] の形で、%1～%2 mmの2つの数値でなければなりません</translation>
    </message>
    <message>
        <source>is not a key that is known here, so it is left out</source>
        <translation>ここで使えるキーではないため、無視されます</translation>
    </message>
    <message>
        <source>is not a key that is known here; did you mean &quot;%1&quot;?</source>
        <translation>ここで使えるキーではありません。「%1」のことですか？</translation>
    </message>
    <message>
        <source>%1 (in the pack %2)</source>
        <translation>%1（パック%2の中）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; belongs to another lesson; give this one an id of its own</source>
        <translation>「%1」は別の課題のものです。この課題に固有のidを付けてください</translation>
    </message>
    <message>
        <source>is missing; write &quot;format&quot;: %1</source>
        <translation>ありません。&quot;format&quot;: %1 と書いてください</translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot; beside the lesson</source>
        <translation>課題と同じ場所にファイル「%1」がありません</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read</source>
        <translation>「%1」を読み取れません</translation>
    </message>
    <message>
        <source>is missing; there are %1</source>
        <translation>ありません。使えるもの：%1</translation>
    </message>
    <message>
        <source>has %1 with all that it names; a recording takes at most %2 along. Shorten its texts</source>
        <translation>指定したものを含めて%1あります。記録に入るのは%2までです。文を短くしてください</translation>
    </message>
    <message>
        <source>is missing; write {&quot;fdi&quot;: 36}, {&quot;block&quot;: &quot;line&quot;} or {&quot;scan&quot;: &quot;tooth.stl&quot;}</source>
        <translation>ありません。{&quot;fdi&quot;: 36}、{&quot;block&quot;: &quot;line&quot;}、{&quot;scan&quot;: &quot;tooth.stl&quot;} のどれかを書いてください</translation>
    </message>
    <message>
        <source>must name one of &quot;fdi&quot;, &quot;block&quot; and &quot;scan&quot;</source>
        <translation>「fdi」「block」「scan」のどれか1つを指定してください</translation>
    </message>
    <message>
        <source>there is no tooth %1 here; those of the left are made: 21 to 28 and 31 to 38</source>
        <translation>歯%1はありません。作れるのは左側の21～28と31～38です</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no unit; write mm, cm, m, in or the millimetres of one unit</source>
        <translation>「%1」は単位ではありません。mm、cm、m、in、または1単位が何ミリメートルかを書いてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no direction; write +x, -x, +y, -y, +z, -z, or three numbers such as 1,0,1</source>
        <translation>「%1」は方向ではありません。+x、-x、+y、-y、+z、-z のどれか、または 1,0,1 のような三つの数を書いてください</translation>
    </message>
    <message>
        <source>an ideal is captured, or has a kind and sizes; leave one out (where the lesson is based on another, with &quot;kind&quot;: null, &quot;sizes&quot;: null)</source>
        <translation>理想形は、取り込んだものか、kindとsizesを持つもののどちらかです。一方を消してください（別の課題に基づく場合は &quot;kind&quot;: null, &quot;sizes&quot;: null と書きます）</translation>
    </message>
    <message>
        <source>is missing; name the preparation, or a file &quot;captured&quot;</source>
        <translation>ありません。窩洞の種類か、ファイル「captured」を指定してください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2; a lesson takes at most %3. Capture it on a coarser grid</source>
        <translation>「%1」は%2あります。課題に入るのは%3までです。粗い格子で取り込んでください</translation>
    </message>
    <message>
        <source>has its own caries and plastic; leave it out, or leave out &quot;caries&quot; and &quot;plastic&quot;</source>
        <translation>う蝕とプラスチックの値を自分で持っています。これを消すか、「caries」と「plastic」を消してください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no aid; there are section, depth_gauge, radiograph, heat_map, mirror, ideal, bur_colour, fixture, depth_stop</source>
        <translation>「%1」という補助はありません。あるもの：section、depth_gauge、radiograph、heat_map、mirror、ideal、bur_colour、fixture、depth_stop</translation>
    </message>
    <message>
        <source>only a tooth of ours has neighbours; write false</source>
        <translation>隣の歯があるのはCuspの歯だけです。falseと書いてください</translation>
    </message>
    <message>
        <source>to remove decay there must be some: write &quot;lesion&quot;: {&quot;extent&quot;: 0.5} for a tooth</source>
        <translation>う蝕を取り除くには、う蝕が必要です。歯に &quot;lesion&quot;: {&quot;extent&quot;: 0.5} と書いてください</translation>
    </message>
    <message>
        <source>is missing; it says which preparation is to be cut</source>
        <translation>ありません。どの窩洞を形成するかを書くものです</translation>
    </message>
    <message>
        <source>a shape is traced in a block: write {&quot;block&quot;: &quot;line&quot;}</source>
        <translation>形をなぞるのはブロックの上です。{&quot;block&quot;: &quot;line&quot;} と書いてください</translation>
    </message>
    <message>
        <source>is missing; it says which points are to be touched: {&quot;points&quot;: [[x, y], ...]}</source>
        <translation>ありません。触れる点を書くものです：{&quot;points&quot;: [[x, y], ...]}</translation>
    </message>
    <message>
        <source>is missing; it says which force is to be held: {&quot;force_n&quot;: 1}</source>
        <translation>ありません。保つ力を書くものです：{&quot;force_n&quot;: 1}</translation>
    </message>
    <message>
        <source>layers are told apart in a block of them: write {&quot;block&quot;: &quot;layers&quot;}</source>
        <translation>層を見分けるのは層のブロックです。{&quot;block&quot;: &quot;layers&quot;} と書いてください</translation>
    </message>
    <message>
        <source>layers are told apart without any; leave the key out</source>
        <translation>層は補助なしで見分けます。このキーを消してください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was captured on the tooth &apos;%2&apos; (seed %3, grid %4); name that tooth, seed and grid, or capture it on this one</source>
        <translation>「%1」は歯「%2」（seed %3、grid %4）で取り込まれました。その歯とseed、gridを指定するか、この歯で取り込んでください</translation>
    </message>
    <message>
        <source>is made by rule for a tooth of ours only, &quot;tooth&quot;: {&quot;fdi&quot;: 36}; for a scan name a captured one: {&quot;captured&quot;: &quot;mine.cuspideal&quot;}</source>
        <translation>規則で作れるのはCuspの歯だけです（&quot;tooth&quot;: {&quot;fdi&quot;: 36}）。スキャンには取り込んだものを指定してください：{&quot;captured&quot;: &quot;mine.cuspideal&quot;}</translation>
    </message>
    <message>
        <source>%1 cannot be read; check its name and rights.</source>
        <translation>%1を読み取れません。名前と権限を確かめてください。</translation>
    </message>
    <message>
        <source>%1 has %2, and a pack takes %3 in all; pack fewer lessons, or coarser scans.</source>
        <translation>%1は%2あり、パックに入るのは合計%3までです。課題を減らすか、粗いスキャンにしてください。</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made; name another.</source>
        <translation>フォルダー%1を作れません。別のフォルダーを指定してください。</translation>
    </message>
    <message>
        <source>The pack names a file &quot;%1&quot;, which leads out of its folder or is of no kind that lessons have; nothing was unpacked.</source>
        <translation>パックにあるファイル「%1」は、フォルダーの外を指しているか、課題が使う種類ではありません。何も展開しませんでした。</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; in the pack is not what its hash says: it was damaged or changed; nothing was unpacked. Ask for the pack again.</source>
        <translation>パックの中のファイル「%1」がチェックサムと合いません。壊れたか変更されています。何も展開しませんでした。パックをもう一度もらってください。</translation>
    </message>
    <message>
        <source>This is no pack of lessons, it is damaged, or it holds more than %1; choose a file that &quot;cusp lesson pack&quot; has made.</source>
        <translation>課題のパックではないか、壊れているか、%1を超えています。コマンドcuspの「lesson pack」で作ったファイルを選んでください。</translation>
    </message>
    <message>
        <source>This is no pack of lessons; choose a file that &quot;cusp lesson pack&quot; has made.</source>
        <translation>課題のパックではありません。コマンドcuspの「lesson pack」で作ったファイルを選んでください。</translation>
    </message>
    <message>
        <source>The pack is of format %1, from a newer Cusp; this one reads %2. Update Cusp.</source>
        <translation>パックの形式は%1で、新しいCuspのものです。このCuspが読めるのは%2です。Cuspを更新してください。</translation>
    </message>
    <message>
        <source>The pack lists %1 files; it may hold 1 to %2.</source>
        <translation>パックに%1個のファイルがあります。入れられるのは1～%2個です。</translation>
    </message>
    <message>
        <source>The pack holds &quot;%1&quot; twice; nothing was unpacked.</source>
        <translation>パックに「%1」が2つあります。何も展開しませんでした。</translation>
    </message>
    <message>
        <source>%1 is a link to elsewhere; nothing was unpacked. Name another folder.</source>
        <translation>%1は別の場所へのリンクです。何も展開しませんでした。別のフォルダーを指定してください。</translation>
    </message>
    <message>
        <source>There is another file &quot;%1&quot; in %2 already; nothing was unpacked. Move it away, or name another folder.</source>
        <translation>%2にはすでに別のファイル「%1」があります。何も展開しませんでした。それを移すか、別のフォルダーを指定してください。</translation>
    </message>
    <message>
        <source>The folder %1 cannot be written.</source>
        <translation>フォルダー%1に書き込めません。</translation>
    </message>
    <message>
        <source>has %1; a hardness preset has at most %2</source>
        <translation>%1あります。硬さのプリセットは%2までです</translation>
    </message>
    <message>
        <source>is %1, from a newer Cusp; this one reads %2. Update Cusp to use it</source>
        <translation>%1で、新しいCuspのものです。このCuspが読めるのは%2です。使うにはCuspを更新してください</translation>
    </message>
    <message>
        <source>says that this is no hardness preset; choose a file that Cusp has exported</source>
        <translation>硬さのプリセットではないと書かれています。Cuspが書き出したファイルを選んでください</translation>
    </message>
    <message>
        <source>must be one line of 1 to %1 characters</source>
        <translation>1～%1文字の1行でなければなりません</translation>
    </message>
    <message>
        <source>is not there; check the name</source>
        <translation>見つかりません。名前を確かめてください</translation>
    </message>
    <message>
        <source>cannot be read; name a file that you may read</source>
        <translation>読み取れません。読み取れるファイルを指定してください</translation>
    </message>
    <message>
        <source>there is another %1 of version %2; give this one another number</source>
        <translation>別の「%1」第%2版があります。こちらには別の番号を付けてください</translation>
    </message>
    <message>
        <source>rubric %1, criterion %2, %3: %4</source>
        <translation>評価基準%1、評価項目%2、%3：%4</translation>
    </message>
    <message>
        <source>%1 %2 is not between %3 and %4</source>
        <translation>%1 %2は%3から%4の間にありません</translation>
    </message>
    <message>
        <source>must be at least 0.1 points</source>
        <translation>0.1点以上でなければなりません</translation>
    </message>
    <message>
        <source>rubric %1, criteria: there are %2, it takes 1 to %3</source>
        <translation>評価基準%1、criteria：%2個あります。1～%3個にしてください</translation>
    </message>
    <message>
        <source>rubric %1, pass_mark: must lie between 0 and 100 points</source>
        <translation>評価基準%1、pass_mark：0～100点でなければなりません</translation>
    </message>
    <message>
        <source>is there twice</source>
        <translation>2つあります</translation>
    </message>
    <message>
        <source>rubric %1, weight: those of all criteria make %2 points; they must make 100</source>
        <translation>評価基準%1、weight：全項目の合計が%2点です。100点にしてください</translation>
    </message>
    <message>
        <source>is %1; points are given to a tenth</source>
        <translation>%1です。点数は0.1点刻みです</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no measure; &quot;cusp lesson measures&quot; lists them</source>
        <translation>「%1」という測定値はありません。コマンドcuspの「lesson measures」で一覧を見られます</translation>
    </message>
    <message>
        <source>may hold small letters, digits, &apos;-&apos; and &apos;_&apos; only, and begins with a letter or digit</source>
        <translation>使えるのは小文字、数字、「-」「_」だけで、先頭は文字か数字です</translation>
    </message>
    <message>
        <source>is missing; name one that is shipped (&quot;decay_removal&quot;), a file beside the lesson, or write it out</source>
        <translation>ありません。付属のもの（「decay_removal」）か、課題と同じ場所のファイルを指定するか、すべて書き出してください</translation>
    </message>
    <message>
        <source>there is no rubric &quot;%1&quot;</source>
        <translation>評価基準「%1」はありません</translation>
    </message>
    <message>
        <source>%1</source>
        <extracomment>%1: what has no words of its own but English ones</extracomment>
        <translation>%1（英語の説明のみ）</translation>
    </message>
    <message>
        <source>the %1 (%2) is not a number</source>
        <extracomment>%1: a number of an ideal or a block, %2: its key, %3: the number that was given</extracomment>
        <translation>%1（%2）が数値ではありません</translation>
    </message>
    <message>
        <source>the %1 (%2) must be from %4 to %5, not %3</source>
        <translation>%1（%2）は%4から%5までです（今は%3）</translation>
    </message>
    <message>
        <source>the %1 (%2) must be from %4 to %5 %6, not %3</source>
        <translation>%1（%2）は%4から%5 %6までです（今は%3）</translation>
    </message>
    <message>
        <source>the %1 (%2) must be a whole number, not %3</source>
        <translation>%1（%2）は整数です（今は%3）</translation>
    </message>
    <message>
        <source>there is no size &quot;%1&quot;; there are %2</source>
        <translation>寸法「%1」はありません。あるもの：%2</translation>
    </message>
    <message>
        <source>the thickness of the enamel layer (enamel_mm) is more than the block&apos;s height (height_mm)</source>
        <translation>エナメル質層の厚さ（enamel_mm）がブロックの高さ（height_mm）を超えています</translation>
    </message>
    <message>
        <source>the block&apos;s side or height (side_mm, height_mm) is too small for three pads: they take %1 and %2 mm</source>
        <translation>ブロックの一辺か高さ（side_mm、height_mm）が3つのパッドには足りません。%1 mmと%2 mmが必要です</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) leaves less than %1 mm of the block around it</source>
        <translation>形の長さ（length_mm）では、まわりに残るブロックが%1 mm未満になります</translation>
    </message>
    <message>
        <source>the depth of the channel (depth_mm) leaves less than %1 mm of the block below it</source>
        <translation>溝の深さ（depth_mm）では、下に残るブロックが%1 mm未満になります</translation>
    </message>
    <message>
        <source>the radius of inner corners (corner_radius_mm) is more than half of the width of the channel (width_mm)</source>
        <translation>内角の半径（corner_radius_mm）が溝の幅（width_mm）の半分を超えています</translation>
    </message>
    <message>
        <source>the radius between floor and wall (line_angle_mm) is more than the radius of inner corners (corner_radius_mm): no bur leaves that</source>
        <translation>窩底と壁の間の半径（line_angle_mm）が内角の半径（corner_radius_mm）を超えています。そのような形を残すバーはありません</translation>
    </message>
    <message>
        <source>the radius between floor and wall (line_angle_mm) is more than the depth (depth_mm)</source>
        <translation>窩底と壁の間の半径（line_angle_mm）が深さ（depth_mm）を超えています</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) must be at least %1 mm with a channel of that width (width_mm)</source>
        <translation>この溝の幅（width_mm）では、形の長さ（length_mm）は%1 mm以上必要です</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) is less than the width of the channel (width_mm)</source>
        <translation>形の長さ（length_mm）が溝の幅（width_mm）より短くなっています</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) leaves each of its steps shorter than the channel is wide (width_mm)</source>
        <translation>この形の長さ（length_mm）では、各段が溝の幅（width_mm）より短くなります</translation>
    </message>
    <message>
        <source>there is no practice block &apos;%1&apos;; choose one of %2</source>
        <translation>練習ブロック「%1」はありません。次から選んでください：%2</translation>
    </message>
    <message>
        <source>there is no preparation &apos;%1&apos;; choose one of %2</source>
        <translation>窩洞「%1」はありません。次から選んでください：%2</translation>
    </message>
    <message>
        <source>the preparation &apos;%1&apos; is not made for tooth %2; it is for %3</source>
        <translation>窩洞「%1」は歯%2にはありません。対象の歯：%3</translation>
    </message>
    <message>
        <source>the radius between floor and wall (line_angle_mm) is more than the radius of the bur (bur_radius_mm): no bur leaves that</source>
        <translation>窩底と壁の間の半径（line_angle_mm）がバーの半径（bur_radius_mm）を超えています。そのような形を残すバーはありません</translation>
    </message>
    <message>
        <source>the width of the isthmus (isthmus_mm) is less than the bur is wide (twice bur_radius_mm)</source>
        <translation>イスムスの幅（isthmus_mm）がバーの太さ（bur_radius_mmの2倍）に足りません</translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make its depth (depth_mm) less</source>
        <translation>この窩洞では露髄します。深さ（depth_mm）を減らしてください</translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make its depth (depth_mm) or that of the box (box_floor_mm, box_axial_mm) less</source>
        <translation>この窩洞では露髄します。深さ（depth_mm）かボックスの深さ（box_floor_mm、box_axial_mm）を減らしてください</translation>
    </message>
    <message>
        <source>nobody knows where the fissures of &apos;%1&apos; run or which side is mesial; choose a tooth by its FDI number, or take an ideal from attempts at this one</source>
        <translation>「%1」の裂溝の位置も近心の向きも分かりません。FDI番号で歯を選ぶか、この歯の試行から理想形を取り込んでください</translation>
    </message>
    <message>
        <source>there is no room for the %1 on this tooth; make one of these less: %2</source>
        <extracomment>%1: a part of a preparation, %2: keys of numbers</extracomment>
        <translation>この歯には入りません（%1）。次のどれかを減らしてください：%2</translation>
    </message>
    <message>
        <source>occlusal outline</source>
        <translation>咬合面の外形</translation>
    </message>
    <message>
        <source>central groove</source>
        <translation>中央溝</translation>
    </message>
    <message>
        <source>mesial pit</source>
        <translation>近心小窩</translation>
    </message>
    <message>
        <source>distal pit</source>
        <translation>遠心小窩</translation>
    </message>
    <message>
        <source>pits</source>
        <translation>小窩</translation>
    </message>
    <message>
        <source>none: the tooth has no such groove</source>
        <translation>なし（この歯にはその溝がありません）</translation>
    </message>
    <message>
        <source>tooth %1 has no pulp chamber that could be opened from above</source>
        <translation>歯%1には、上から開拡できる髄室がありません</translation>
    </message>
    <message>
        <source>The captured ideal is damaged. Use a copy of the file, or capture it again.</source>
        <translation>取り込んだ理想形が壊れています。ファイルの控えを使うか、取り込み直してください。</translation>
    </message>
    <message>
        <source>The ideal was captured on the tooth &apos;%1&apos; (seed %2, grid %3) and does not fit &apos;%4&apos; (seed %5, grid %6); name that tooth, seed and grid, or capture it on this one.</source>
        <translation>理想形は歯「%1」（seed %2、grid %3）で取り込まれ、「%4」（seed %5、grid %6）には合いません。その歯とseed、gridを指定するか、この歯で取り込んでください。</translation>
    </message>
    <message>
        <source>The captured ideal is empty; choose another file.</source>
        <translation>取り込んだ理想形が空です。別のファイルを選んでください。</translation>
    </message>
    <message>
        <source>This is not a captured ideal; choose a file that Cusp has saved as one (*.cuspideal).</source>
        <translation>取り込んだ理想形ではありません。Cuspが理想形として保存したファイル（*.cuspideal）を選んでください。</translation>
    </message>
    <message>
        <source>The captured ideal is of version %1, this Cusp reads up to version %2; open it with a newer Cusp.</source>
        <translation>取り込んだ理想形は第%1版で、このCuspが読めるのは第%2版までです。新しいCuspで開いてください。</translation>
    </message>
    <message>
        <source>The captured ideal ends early: it was cut off while being written or copied. Use a whole copy.</source>
        <translation>取り込んだ理想形が途中で終わっています。書き込みかコピーの途中で切れました。完全な控えを使ってください。</translation>
    </message>
    <message>
        <source>The firmware file is empty; choose another file.</source>
        <translation>ファームウェアのファイルが空です。別のファイルを選んでください。</translation>
    </message>
    <message>
        <source>The file is larger than %1 KiB and cannot be firmware for the Falcon; choose another file.</source>
        <translation>ファイルが %1 KiB より大きく、Falcon のファームウェアではありません。別のファイルを選んでください。</translation>
    </message>
    <message>
        <source>This is not firmware for the Falcon; choose another file.</source>
        <translation>これは Falcon のファームウェアではありません。別のファイルを選んでください。</translation>
    </message>
    <message>
        <source>The firmware file is too short: it has %1 bytes, and its header alone has %2. Use a complete copy.</source>
        <translation>ファームウェアのファイルが短すぎます。%1 バイトしかなく、先頭部だけで %2 バイトあるはずです。完全な控えを使ってください。</translation>
    </message>
    <message>
        <source>The firmware file ends before its block %1 is complete. Use a complete copy.</source>
        <translation>ファームウェアのファイルが、ブロック %1 の途中で終わっています。完全な控えを使ってください。</translation>
    </message>
    <message>
        <source>The firmware ends after %1 bytes, but the file has %2. Use an unchanged copy.</source>
        <translation>ファームウェアは %1 バイトで終わりますが、ファイルは %2 バイトあります。変更されていない控えを使ってください。</translation>
    </message>
    <message>
        <source>There is no handpiece &apos;%1&apos;; choose one of %2.</source>
        <translation>ハンドピース「%1」はありません。次から選んでください：%2。</translation>
    </message>
    <message>
        <source>There is no bur &apos;%1&apos;; choose one of %2.</source>
        <translation>バー「%1」はありません。次から選んでください：%2。</translation>
    </message>
    <message>
        <source>There is no hardness preset &apos;%1&apos;; choose natural or typodont, or name a file.</source>
        <translation>硬さのプリセット「%1」はありません。naturalかtypodontを選ぶか、ファイルを指定してください。</translation>
    </message>
    <message>
        <source>the force limit is %1 N, and the device gives at most %2 N; lower it</source>
        <translation>力の上限は%1 Nですが、装置が出せるのは%2 Nまでです。下げてください</translation>
    </message>
    <message>
        <source>the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm with this damping; lower the stiffness, or damp more</source>
        <translation>剛性は%1 N/mmですが、遅れ%2 msとこの減衰では、軽い手が安定するのは%3 N/mmまでです。剛性を下げるか、減衰を増やしてください</translation>
    </message>
    <message>
        <source>the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm however it is damped; lower the stiffness</source>
        <translation>剛性は%1 N/mmですが、遅れ%2 msでは、減衰に関わらず軽い手が安定するのは%3 N/mmまでです。剛性を下げてください</translation>
    </message>
    <message>
        <source>the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm before it buzzes; lower the stiffness</source>
        <translation>剛性は%1 N/mmですが、遅れ%2 msでは、軽い手が安定するのは%3 N/mmまでで、それを超えると細かく震えます。剛性を下げてください</translation>
    </message>
    <message>
        <source>points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>percent</source>
        <translation>パーセント</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>minutes</source>
        <translation>分</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1: the name of a file; %2: what is wrong with it: &quot;is empty&quot;</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>says nothing of %1: that is as shipped</source>
        <translation>%1 の記載がありません。それらは付属の値になります</translation>
    </message>
    <message>
        <source>%1 has the last version that there can be, %2; keep this under another name</source>
        <translation>%1 は最後のバージョン %2 に達しています。別の名前で保存してください</translation>
    </message>
    <message>
        <source>The USB of this computer cannot be used (%1). The mouse works without it.</source>
        <translation>このコンピューターの USB を使用できません (%1)。マウスはそのまま使えます。</translation>
    </message>
    <message>
        <source>You have no permission to use the Falcon. Install the rule that %1 prints, then unplug the Falcon and plug it in again.</source>
        <translation>Falcon を使用する権限がありません。%1が出力するルールをインストールし、Falcon を抜いて差し直してください。</translation>
    </message>
    <message>
        <source>Another program uses the Falcon. Close that program.</source>
        <translation>ほかのプログラムが Falcon を使用しています。そのプログラムを終了してください。</translation>
    </message>
    <message>
        <source>Another driver of the system holds the Falcon. Give it the driver WinUSB.</source>
        <translation>システムの別のドライバーが Falcon を占有しています。WinUSB ドライバーを割り当ててください。</translation>
    </message>
    <message>
        <source>The USB connection to the Falcon failed (%1). Unplug the Falcon and plug it in again.</source>
        <translation>Falcon との USB 接続に失敗しました (%1)。Falcon を抜いて差し直してください。</translation>
    </message>
    <message>
        <source>No Falcon is plugged in.</source>
        <translation>Falcon が接続されていません。</translation>
    </message>
    <message>
        <source>The Falcon does not answer. Check that its mains adapter is plugged in, then unplug its USB cable and plug it in again.</source>
        <translation>Falcon が応答しません。電源アダプターが接続されていることを確認し、USB ケーブルを抜いて差し直してください。</translation>
    </message>
    <message>
        <source>The Falcon was unplugged while its firmware was loaded.</source>
        <translation>ファームウェアの読み込み中に Falcon が抜かれました。</translation>
    </message>
    <message>
        <source>The Falcon received byte %1 of the firmware wrongly. Try another USB port, without a hub.</source>
        <translation>Falcon がファームウェアのバイト %1 を正しく受信できませんでした。ハブを使わず、別の USB ポートを試してください。</translation>
    </message>
    <message>
        <source>Loading the firmware was stopped.</source>
        <translation>ファームウェアの読み込みを中止しました。</translation>
    </message>
    <message>
        <source>The firmware file cannot be read; choose it again.</source>
        <translation>ファームウェアファイルを読み込めません。もう一度選択してください。</translation>
    </message>
    <message>
        <source>The Falcon needs its firmware, which cannot be shipped with Cusp. Choose the firmware file of your Falcon&apos;s software.</source>
        <translation>Falcon にはファームウェアが必要ですが、Cusp に同梱することはできません。お使いの Falcon のソフトウェアに含まれるファームウェアファイルを選択してください。</translation>
    </message>
    <message>
        <source>The firmware was loaded, but does not answer. Try another firmware file.</source>
        <translation>ファームウェアは読み込まれましたが、応答がありません。別のファームウェアファイルを試してください。</translation>
    </message>
    <message>
        <source>This program was built without libusb: force devices are left out.</source>
        <translation>このプログラムは libusb なしでビルドされています。力覚デバイスは利用できません。</translation>
    </message>
    <message>
        <source>No Falcon with the serial number %1 is plugged in.</source>
        <translation>シリアル番号 %1 の Falcon は接続されていません。</translation>
    </message>
    <message>
        <source>Cusp cannot read pictures: its file %1 or a library of OpenCV is missing. Install Cusp again. The mouse works without it.</source>
        <translation>Cusp は画像を読み込めません：ファイル %1 または OpenCV のライブラリがありません。Cusp をインストールし直してください。マウスはそれらがなくても使えます。</translation>
    </message>
    <message>
        <source>There is no camera %1. Plug in a camera, or choose another one.</source>
        <translation>カメラ %1 はありません。カメラを接続するか、別のカメラを選んでください。</translation>
    </message>
    <message>
        <source>You have no permission to use camera %1. An administrator of this computer can add you to the group &quot;video&quot;.</source>
        <translation>カメラ %1 を使う権限がありません。このコンピューターの管理者は、あなたをグループ「video」に追加できます。</translation>
    </message>
    <message>
        <source>Camera %1 gives no pictures. Close other programs that use it, or choose another one.</source>
        <translation>カメラ %1 から映像が得られません。そのカメラを使っているほかのプログラムを閉じるか、別のカメラを選んでください。</translation>
    </message>
    <message>
        <source>Camera %1 gives no more pictures. Check that it is plugged in.</source>
        <translation>カメラ %1 から映像が得られなくなりました。接続されているか確かめてください。</translation>
    </message>
    <message>
        <source>There is no file %1.</source>
        <translation>ファイル %1 はありません。</translation>
    </message>
    <message>
        <source>The file %1 cannot be read.</source>
        <translation>ファイル %1 を読み込めません。</translation>
    </message>
    <message>
        <source>%1 is no video, or of a kind that cannot be read here.</source>
        <translation>%1 は動画でないか、ここでは読み込めない種類です。</translation>
    </message>
    <message>
        <source>The calibration is for pictures of %1 x %2 pixels, and these have %3 x %4. Calibrate the camera at this size.</source>
        <translation>この較正は %1 x %2 画素の画像用ですが、この画像は %3 x %4 画素です。この大きさでカメラを較正してください。</translation>
    </message>
    <message>
        <source>The file %1 is too large for a calibration.</source>
        <translation>ファイル %1 は校正としては大きすぎます。</translation>
    </message>
    <message>
        <source>%1 is no calibration of a camera.</source>
        <translation>%1 はカメラの校正ではありません。</translation>
    </message>
    <message>
        <source>%1: a value is missing or is not a number.</source>
        <translation>%1: 値がないか、数値ではありません。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The size of the pictures must be 1 to 16384 pixels a side.</source>
        <translation>映像の一辺は 1 から 16384 ピクセルでなければなりません。</translation>
    </message>
    <message>
        <source>The optical centre of a camera must lie within its pictures.</source>
        <translation>カメラの光学中心は映像の中になければなりません。</translation>
    </message>
    <message>
        <source>The coefficients of a lens must lie between -5 and 5.</source>
        <translation>レンズの係数は -5 から 5 の間でなければなりません。</translation>
    </message>
    <message>
        <source>The focal length of a camera must be 0.1 to 20 times the width of its pictures.</source>
        <translation>カメラの焦点距離は映像の幅の 0.1 から 20 倍でなければなりません。</translation>
    </message>
    <message>
        <source>This program was built without SDL 2: pedals and gamepads are left out.</source>
        <translation>このプログラムは SDL 2 なしで作られました。ペダルとゲームパッドは使えません。</translation>
    </message>
    <message>
        <source>Pedals and gamepads cannot be read (%1). The mouse and the keyboard work without them.</source>
        <translation>ペダルとゲームパッドを読み取れません（%1）。マウスとキーボードはそのまま使えます。</translation>
    </message>
    <message>
        <source>must lie between 0.1 and 100 points, at a criterion without weight</source>
        <translation>0.1から100点の間で、配点のない項目に指定します</translation>
    </message>
    <message>
        <source>a critical criterion has none; it limits the points of the whole attempt</source>
        <translation>重大な項目にはありません。全体の得点を制限します</translation>
    </message>
    <message>
        <source>a critical criterion leaves no points; give one of the two</source>
        <translation>重大な項目は得点を残しません。どちらか一方を指定してください</translation>
    </message>
    <message>
        <source>must be at least 0.1 points; an error that leaves none is &quot;critical&quot;</source>
        <translation>0.1点以上にしてください。得点を残さない誤りは &quot;critical&quot; です</translation>
    </message>
    <message>
        <source>is how far the tooth lies on a side; say which in &quot;lies&quot;</source>
        <translation>は歯をどれだけ横に傾けるかです。どの面かを&quot;lies&quot;に書いてください</translation>
    </message>
    <message>
        <source>a tooth that lies on a side has no neighbours; write false</source>
        <translation>横向きの歯に隣在歯はありません。falseと書いてください</translation>
    </message>
    <message>
        <source>is about a tooth that stands upright</source>
        <translation>は直立した歯についてのものです</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no side of a tooth; write occlusal, mesial, distal, buccal or lingual</source>
        <translation>「%1」は歯の面ではありません。occlusal、mesial、distal、buccal、lingualのいずれかを書いてください</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no side of a scan; write occlusal, -x, +x, -y or +y</source>
        <translation>「%1」はスキャンの面ではありません。occlusal、-x、+x、-y、+yのいずれかを書いてください</translation>
    </message>
    <message>
        <source>a tooth is tilted by %1 to %2 degrees, not by %3</source>
        <translation>歯の傾きは%1～%2度です。%3度にはできません</translation>
    </message>
    <message>
        <source>a bur reaches no fissure of a tooth that is tilted by more than %1 degrees</source>
        <translation>%1度を超えて傾けた歯では、バーは裂溝に届きません</translation>
    </message>
    <message>
        <source>decay below a contact is on the mesial or distal side; let the tooth lie that way</source>
        <translation>接触点下のう蝕は近心面か遠心面にあります。その面を上にしてください</translation>
    </message>
    <message>
        <source>decay at the neck or in a pit of a side is on the buccal or lingual side; let the tooth lie that way</source>
        <translation>歯頸部や側面の小窩のう蝕は頬側か舌側にあります。その面を上にしてください</translation>
    </message>
    <message>
        <source>there is no pit on the side that tooth &apos;%1&apos; shows</source>
        <translation>歯%1の上を向いた面に小窩はありません</translation>
    </message>
    <message>
        <source>this preparation is made for a tooth that stands upright; leave out &quot;lies&quot;, or take an ideal from attempts at this tooth</source>
        <translation>この形成は直立した歯のためのものです。&quot;lies&quot;を省くか、この歯での試行から理想形を取ってください</translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make the depth of the box (box_floor_mm, box_axial_mm) less</source>
        <translation>この窩洞では露髄します。ボックスの深さ（box_floor_mm、box_axial_mm）を減らしてください</translation>
    </message>
    <message>
        <source>the length of the shape (length_mm) leaves less than %1 mm of the block between its pits (width_mm, steps)</source>
        <translation>形の長さ（length_mm）では、穴の間にブロックが%1 mm残りません（width_mm、steps）</translation>
    </message>
    <message>
        <source>the enamel is thinner where it is thickest (depth_mm) than where it is thinnest (enamel_mm)</source>
        <translation>エナメル質の最も厚い所（depth_mm）が最も薄い所（enamel_mm）より薄くなっています</translation>
    </message>
    <message>
        <source>this preparation would open the pulp; make the reduction (reduction_mm, functional_mm) less</source>
        <translation>この形成では露髄します。削除量（reduction_mm、functional_mm）を小さくしてください</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>width of the isthmus</source>
        <translation>イスムスの幅</translation>
    </message>
    <message>
        <source>depth of the pulpal floor</source>
        <translation>窩底の深さ</translation>
    </message>
    <message>
        <source>width of the dovetail</source>
        <translation>鳩尾形の幅</translation>
    </message>
    <message>
        <source>extension into the grooves</source>
        <translation>裂溝への延長</translation>
    </message>
    <message>
        <source>marginal ridge that is left</source>
        <translation>残る辺縁隆線</translation>
    </message>
    <message>
        <source>ridge across the tooth that is left on each side</source>
        <translation>両側に残る横走隆線</translation>
    </message>
    <message>
        <source>divergence of the end walls</source>
        <translation>端壁の開き</translation>
    </message>
    <message>
        <source>radius of the bur</source>
        <translation>バーの半径</translation>
    </message>
    <message>
        <source>radius between floor and wall</source>
        <translation>窩底と壁の間の半径</translation>
    </message>
    <message>
        <source>floor along the junction</source>
        <translation>エナメル象牙境に沿う窩底</translation>
    </message>
    <message>
        <source>depth of the floor in dentin</source>
        <translation>象牙質内の窩底の深さ</translation>
    </message>
    <message>
        <source>depth of the gingival floor</source>
        <translation>歯肉側窩底の深さ</translation>
    </message>
    <message>
        <source>depth of the axial wall</source>
        <translation>軸側壁の深さ</translation>
    </message>
    <message>
        <source>width of the box</source>
        <translation>ボックスの幅</translation>
    </message>
    <message>
        <source>lean of the access walls</source>
        <translation>髄室開拡の壁の傾き</translation>
    </message>
    <message>
        <source>margin around the chamber</source>
        <translation>髄室まわりの余裕</translation>
    </message>
    <message>
        <source>block&apos;s side</source>
        <translation>ブロックの一辺</translation>
    </message>
    <message>
        <source>block&apos;s height</source>
        <translation>ブロックの高さ</translation>
    </message>
    <message>
        <source>thickness of the enamel layer</source>
        <translation>エナメル質層の厚さ</translation>
    </message>
    <message>
        <source>width of the channel</source>
        <translation>溝の幅</translation>
    </message>
    <message>
        <source>depth of the channel</source>
        <translation>溝の深さ</translation>
    </message>
    <message>
        <source>length of the shape</source>
        <translation>形の長さ</translation>
    </message>
    <message>
        <source>flare of the dovetail</source>
        <translation>鳩尾形の広がり</translation>
    </message>
    <message>
        <source>number of steps</source>
        <translation>段の数</translation>
    </message>
    <message>
        <source>radius of inner corners</source>
        <translation>内角の半径</translation>
    </message>
    <message>
        <source>occlusal reduction</source>
        <translation>咬合面の削除量</translation>
    </message>
    <message>
        <source>reduction of the functional cusps</source>
        <translation>機能咬頭の削除量</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>version %1 of the lesson %2 was changed or is damaged; assign the lesson again</source>
        <translation>課題%2の版%1は変更されたか破損しています。課題をもう一度割り当ててください</translation>
    </message>
    <message>
        <source>row %1 of the audit was not written by Cusp: the role of person:%2 did not permit %3 on %4 then</source>
        <translation>監査ログの行%1はCuspが書いたものではありません：当時のperson:%2の役割では%4に対する%3は許可されていません</translation>
    </message>
    <message>
        <source>row %1 of the audit (%2): a computer had seen later rows of it. If nobody restored a backup without Cusp then, somebody put an older copy in the place of the database</source>
        <translation>監査ログの行%1（%2）：あるコンピューターはそれより後の行を見ていました。そのときCuspを使わずにバックアップを復元した人がいなければ、誰かがデータベースを古いコピーに置き換えています</translation>
    </message>
    <message>
        <source>%1 attempts do not match their recordings and do not count; the pages of the classes mark them</source>
        <translation>%1件の試行は記録と一致せず、数えられません。クラスのページに印が付いています</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no audit code; a report shows one such as 412-9f3ac07be1d2</source>
        <translation>「%1」は監査コードではありません。レポートには 412-9f3ac07be1d2 のように表示されます</translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) tells that the rows before it did not end as they had been signed</source>
        <translation>監査記録の %1 行（%2、%3、%4）は、その前の行が署名された状態で終わっていなかったことを示しています</translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) is not the one that was signed: it was changed, or the signature was put there from elsewhere</source>
        <translation>監査記録の %1 行（%2、%3、%4）は署名された行ではありません。改変されたか、署名が別のところから持ち込まれています</translation>
    </message>
    <message>
        <source>the signature of the newest row of the audit was not made by the station whose key stands beside it</source>
        <translation>監査記録の最新の行の署名は、横に記されている鍵の端末によるものではありません</translation>
    </message>
    <message>
        <source>audit row %1 was removed</source>
        <translation>監査記録の %1 行が削除されています</translation>
    </message>
    <message>
        <source>no signature covers audit row %1: it was inserted, or the signed head was set back, or the row behind it was changed</source>
        <translation>監査記録の %1 行はどの署名にも含まれていません。挿入されたか、署名された先頭が以前のものに戻されたか、次の行が改変されています</translation>
    </message>
    <message>
        <source>the signed head of the audit was removed</source>
        <translation>監査記録の署名された先頭が削除されています</translation>
    </message>
    <message>
        <source>the file is damaged: %1</source>
        <translation>ファイルが破損しています：%1</translation>
    </message>
    <message>
        <source>row %1 of the table %2 belongs to no row of %3</source>
        <translation>表 %2 の %1 行に対応する %3 の行がありません</translation>
    </message>
    <message>
        <source>%1 (%2, %3) was changed after it had been kept</source>
        <translation>%1（%2、%3）が保存後に改変されています</translation>
    </message>
    <message>
        <source>%1 was removed; row %2 of the audit tells of it</source>
        <translation>%1 が削除されています。監査記録の %2 行に記載があります</translation>
    </message>
    <message>
        <source>%1 has no score sheet</source>
        <translation>%1 に採点表がありません</translation>
    </message>
    <message>
        <source>%1 has a standing in %2 that the attempts do not add up to</source>
        <translation>%1 の %2 の成績が試行の結果と一致しません</translation>
    </message>
    <message>
        <source>%1 has attempts in %2 and no standing</source>
        <translation>%1 には %2 の試行がありますが、成績がありません</translation>
    </message>
    <message>
        <source>the recording %1 is not there any more; bring the folder &quot;recordings&quot; back from a backup</source>
        <translation>記録 %1 が見つかりません。バックアップからフォルダー「recordings」を復元してください</translation>
    </message>
    <message>
        <source>the recording %1 was changed or is damaged; bring it back from a backup</source>
        <translation>記録 %1 が改変または破損しています。バックアップから復元してください</translation>
    </message>
    <message>
        <source>the head of the audit was signed with the key %1, which is not this computer&apos;s; if the file was not written by Cusp on another computer, somebody has rewritten it</source>
        <translation>監査記録の先頭は鍵 %1 で署名されていますが、これはこのコンピューターの鍵ではありません。別のコンピューターの Cusp が書いたファイルでなければ、誰かが書き換えています</translation>
    </message>
    <message>
        <source>%1 is no longer there: what it guarded is not guarded any more</source>
        <translation>%1 がなくなっています。保護されていたものは保護されていません</translation>
    </message>
    <message>
        <source>the newest row of the audit was signed with the key %1, and the audit knows no station that has it</source>
        <translation>監査記録の最新の行は鍵 %1 で署名されていますが、その鍵を持つ端末は監査記録にありません</translation>
    </message>
    <message>
        <source>audit row %1, which a report names, is not there: it was removed, or the code is not typed as it stands there</source>
        <translation>報告書にある監査記録の %1 行がありません。削除されたか、コードの入力が報告書と違います</translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) is not the one that a report names: it or one before it was changed, or the code is not typed as it stands there</source>
        <translation>監査記録の %1 行（%2、%3、%4）は報告書にあるものと違います。この行かそれより前の行が変更されたか、コードの入力が報告書と違います</translation>
    </message>
    <message>
        <source>%1 (%2, %3) is not noted in the audit: it was inserted, or the note of it is among the rows of the audit that were removed or changed</source>
        <translation>%1（%2、%3）は監査記録に記載がありません。挿入されたか、削除または変更された監査記録の行に記載されていました</translation>
    </message>
    <message>
        <source>audit row %1 (%2, %3, %4) does not follow from the row before it: one of the two was changed, inserted or moved</source>
        <translation>監査記録の行 %1(%2、%3、%4)は前の行に続いていません。どちらかの行が変更、挿入、または移動されました</translation>
    </message>
    <message>
        <source>the audit itself was changed: rows that differ from it may be right all the same</source>
        <translation>監査記録そのものが変更されています。それと異なる行も正しい可能性があります</translation>
    </message>
    <message>
        <source>the check could not go on: %1</source>
        <translation>検査を続けられませんでした: %1</translation>
    </message>
    <message>
        <source>%1 differs from the audit: the row of %2 was changed, added or removed</source>
        <translation>%1が監査記録と異なります。%2の行が変更、追加、または削除されました</translation>
    </message>
</context>
<context>
    <name>Handpiece</name>
    <message>
        <source>Turbine</source>
        <translation>タービン</translation>
    </message>
    <message>
        <source>Electric</source>
        <extracomment>A red-ring contra-angle: electric motor, geared up</extracomment>
        <translation>電動</translation>
    </message>
    <message>
        <source>Low-speed</source>
        <translation>低速</translation>
    </message>
</context>
<context>
    <name>Health</name>
    <message>
        <source>The handpiece is disconnected: no force. Plug it in again.</source>
        <translation>ハンドピースがありません：力は出ません。接続し直してください。</translation>
    </message>
    <message>
        <source>The computer was too slow: the recording has a gap.</source>
        <translation>コンピューターが遅すぎました：記録に欠落があります。</translation>
    </message>
    <message>
        <source>The computer is slow: the picture lags behind.</source>
        <translation>コンピューターが遅く、画像が遅れています。</translation>
    </message>
    <message>
        <source>The bur is inside the tooth. Lift it out to continue.</source>
        <translation>バーが歯の内部にあります。引き上げると動作します。</translation>
    </message>
    <message>
        <source>The outline holds your hand. Press Q to release it.</source>
        <translation>外形線が手を保持しています。Qで解除します。</translation>
    </message>
    <message>
        <source>The handpiece guides your hand back over the tooth. Push against it to stop.</source>
        <translation>ハンドピースが手を歯の上へ導きます。押し返すと止まります。</translation>
    </message>
    <message>
        <source>The handpiece responds late: the tooth feels softer.</source>
        <translation>ハンドピースの応答が遅いため、歯の手応えを柔らかくしています。</translation>
    </message>
    <message>
        <source>Force at its limit</source>
        <translation>力が上限に達しています</translation>
    </message>
</context>
<context>
    <name>HistoryPanel</name>
    <message>
        <source>Intact tooth</source>
        <translation>切削前の歯</translation>
    </message>
    <message>
        <source>Tooth reset</source>
        <translation>歯をリセット</translation>
    </message>
    <message>
        <source>%1 mm³ %2</source>
        <extracomment>What a stroke took off: so many cubic millimetres of a tissue</extracomment>
        <translation>%2 %1 mm³</translation>
    </message>
    <message>
        <source>present</source>
        <translation>現在</translation>
    </message>
</context>
<context>
    <name>Landmark</name>
    <message>
        <source>central pit</source>
        <translation>中央小窩</translation>
    </message>
    <message>
        <source>mesial pit</source>
        <translation>近心小窩</translation>
    </message>
    <message>
        <source>distal pit</source>
        <translation>遠心小窩</translation>
    </message>
    <message>
        <source>mesial marginal ridge</source>
        <translation>近心辺縁隆線</translation>
    </message>
    <message>
        <source>distal marginal ridge</source>
        <translation>遠心辺縁隆線</translation>
    </message>
</context>
<context>
    <name>Lesson</name>
    <message>
        <source>Practice block</source>
        <translation>練習ブロック</translation>
    </message>
    <message>
        <source>Exams</source>
        <translation>試験</translation>
    </message>
    <message>
        <source>Ideal preparations</source>
        <translation>理想的な窩洞形成</translation>
    </message>
    <message>
        <source>The first minutes</source>
        <translation>最初の数分</translation>
    </message>
    <message>
        <source>Removing decay</source>
        <translation>う蝕の除去</translation>
    </message>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>section</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>depth gauge</source>
        <translation>深さ計</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>X線</translation>
    </message>
    <message>
        <source>depth colours</source>
        <translation>深さの色分け</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>ミラー</translation>
    </message>
    <message>
        <source>ideal preparation</source>
        <translation>理想形</translation>
    </message>
    <message>
        <source>bur that changes colour</source>
        <translation>色の変わるバー</translation>
    </message>
    <message>
        <source>guided hand</source>
        <translation>手の誘導</translation>
    </message>
    <message>
        <source>depth stop</source>
        <translation>深さストップ</translation>
    </message>
    <message>
        <source>all</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1分</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>制限なし</translation>
    </message>
    <message>
        <source>%1 ± %2 costs nothing</source>
        <extracomment>%1: a target; %2: how far off it one may be at no cost</extracomment>
        <translation>%1 ± %2は減点なし</translation>
    </message>
    <message>
        <source>%1 or more costs nothing</source>
        <translation>%1以上は減点なし</translation>
    </message>
    <message>
        <source>Up to %1 costs nothing</source>
        <translation>%1以下は減点なし</translation>
    </message>
    <message>
        <source> (more, where the decay is larger)</source>
        <translation>（う蝕が大きい箇所ではさらに）</translation>
    </message>
    <message>
        <source> as soon as %1</source>
        <extracomment>%1: what has to be done before points are earned: &quot;50 % of the decay is removed&quot;</extracomment>
        <translation>（%1以降）</translation>
    </message>
    <message>
        <source>beyond it the attempt fails</source>
        <translation>それを超えると不合格です</translation>
    </message>
    <message>
        <source>beyond it all %1 points are lost</source>
        <translation>それを超えると%1点すべてを失います</translation>
    </message>
    <message>
        <source>%1 off, all %2 points are lost</source>
        <translation>%1ずれると%2点すべてを失います</translation>
    </message>
    <message>
        <source>at %1 all %2 points are lost</source>
        <translation>%1で%2点すべてを失います</translation>
    </message>
    <message>
        <source>from %1 on all %2 points are lost</source>
        <translation>%1以上で%2点すべてを失います</translation>
    </message>
    <message>
        <source>outline %1 mm to either side</source>
        <translation>外形 両側へ%1 mm</translation>
    </message>
    <message>
        <source>floor %1 mm up or down</source>
        <translation>窩底 上下%1 mm</translation>
    </message>
    <message>
        <source>walls %1°, that is %2 mm over 1.5 mm of depth</source>
        <translation>壁 %1°（深さ1.5 mmで%2 mm）</translation>
    </message>
    <message>
        <source>floor even to %1 mm</source>
        <translation>窩底の平坦さ %1 mm</translation>
    </message>
    <message>
        <source>%1: %2 points</source>
        <translation>%1：%2点</translation>
    </message>
    <message>
        <source>exam</source>
        <extracomment>On the card of a lesson</extracomment>
        <translation>試験</translation>
    </message>
    <message>
        <source>in progress</source>
        <extracomment>On the card of the lesson that is being worked on</extracomment>
        <translation>作業中</translation>
    </message>
    <message>
        <source>due since %1</source>
        <translation>%1 が締切でした</translation>
    </message>
    <message>
        <source>due today %1</source>
        <translation>今日 %1 締切</translation>
    </message>
    <message>
        <source>due tomorrow</source>
        <translation>明日締切</translation>
    </message>
    <message>
        <source>due %1</source>
        <extracomment>%1: a day of the week, or a date</extracomment>
        <translation>締切：%1</translation>
    </message>
    <message>
        <source>You have no attempts left at this lesson. Your teacher can give you more.</source>
        <translation>この課題の試行回数を使い切りました。教員が追加できます。</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n day(s) late</source>
        <extracomment>%1: the day it was due, &quot;17 Nov&quot;</extracomment>
        <translation>
            <numerusform>%1、%n 日遅れ</numerusform>
        </translation>
    </message>
    <message>
        <source>no attempts left</source>
        <extracomment>On the card of a lesson</extracomment>
        <translation>試行回数の残りなし</translation>
    </message>
    <message>
        <source>Your last attempt at this exam was started in another window. The work in this window does not count.</source>
        <translation>この試験の最後の試行は別のウィンドウで始められました。このウィンドウでの作業は数えられません。</translation>
    </message>
    <message>
        <source>In an exam, the expert&apos;s attempt is not shown.</source>
        <translation>試験では、エキスパートの試行は表示されません。</translation>
    </message>
    <message>
        <source>Only lessons have an expert&apos;s attempt. Press F2 to choose one.</source>
        <translation>エキスパートの試行があるのはレッスンだけです。F2を押してレッスンを選んでください。</translation>
    </message>
    <message>
        <source>This exercise has no expert&apos;s attempt.</source>
        <translation>この練習にはエキスパートの試行がありません。</translation>
    </message>
    <message>
        <source>beyond it the score is limited to %1 points</source>
        <extracomment>%1: points of a score</extracomment>
        <translation>それを超えると得点は最大%1点</translation>
    </message>
    <message>
        <source>At most %1 points: %2</source>
        <extracomment>%1: points of a score; %2: serious errors, with semicolons between</extracomment>
        <translation>最大%1点：%2</translation>
    </message>
    <message>
        <source>Fails the attempt: %1</source>
        <extracomment>%1: serious errors, with semicolons between</extracomment>
        <translation>不合格になる：%1</translation>
    </message>
    <message>
        <source>mesial side towards the bur</source>
        <translation>近心面をバーに向けて置く</translation>
    </message>
    <message>
        <source>distal side towards the bur</source>
        <translation>遠心面をバーに向けて置く</translation>
    </message>
    <message>
        <source>buccal side towards the bur</source>
        <translation>頬側面をバーに向けて置く</translation>
    </message>
    <message>
        <source>lingual side towards the bur</source>
        <translation>舌側面をバーに向けて置く</translation>
    </message>
    <message>
        <source>%1 towards the bur</source>
        <extracomment>%1: a direction of a scan, such as &quot;+x&quot;</extracomment>
        <translation>%1をバーに向けて置く</translation>
    </message>
</context>
<context>
    <name>Login</name>
    <message>
        <source>Wrong username or password. Try again, or ask an admin for a one-time code.</source>
        <translation>ユーザー名またはパスワードが違います。もう一度お試しいただくか、管理者にワンタイムコードを依頼してください。</translation>
    </message>
    <message numerus="yes">
        <source>Too many logins have failed. Wait %n second(s) and try again.</source>
        <translation>
            <numerusform>ログインの失敗が多すぎます。%n秒待ってからもう一度お試しください。</numerusform>
        </translation>
    </message>
    <message>
        <source>A user was added here in the meantime. Log in as an admin.</source>
        <translation>その間にユーザーが追加されました。管理者としてログインしてください。</translation>
    </message>
    <message>
        <source>The school&apos;s server does not answer. Try again, or practise without a login.</source>
        <translation>学校のサーバーが応答しません。もう一度お試しいただくか、ログインせずに練習してください。</translation>
    </message>
    <message>
        <source>A password has at least eight characters, does not contain the username and is not a common one such as &quot;password1&quot;.</source>
        <translation>パスワードは8文字以上で、ユーザー名を含まず、「password1」のようなよくあるものではないようにしてください。</translation>
    </message>
    <message>
        <source>Another program is writing to the school&apos;s database, so nobody can log in. Try again in a moment.</source>
        <translation>ほかのプログラムが学校のデータベースに書き込んでいるため、ログインできません。少し待ってからもう一度お試しください。</translation>
    </message>
</context>
<context>
    <name>Material</name>
    <message>
        <source>decay</source>
        <translation>う蝕</translation>
    </message>
    <message>
        <source>enamel</source>
        <translation>エナメル質</translation>
    </message>
    <message>
        <source>dentin</source>
        <translation>象牙質</translation>
    </message>
    <message>
        <source>pulp</source>
        <translation>歯髄</translation>
    </message>
    <message>
        <source>C</source>
        <extracomment>One letter for decay (caries); must differ from those of enamel, dentin and pulp.</extracomment>
        <translation>う</translation>
    </message>
    <message>
        <source>E</source>
        <extracomment>One letter for enamel</extracomment>
        <translation>エ</translation>
    </message>
    <message>
        <source>D</source>
        <extracomment>One letter for dentin</extracomment>
        <translation>象</translation>
    </message>
    <message>
        <source>P</source>
        <extracomment>One letter for pulp</extracomment>
        <translation>髄</translation>
    </message>
</context>
<context>
    <name>Pad</name>
    <message>
        <source>Left</source>
        <extracomment>Three pads of a practice block, side by side</extracomment>
        <translation>左</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>中央</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
</context>
<context>
    <name>Printing</name>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
</context>
<context>
    <name>Scan</name>
    <message>
        <source>Taken as millimetres the scan is %1 mm long, more than a tooth.</source>
        <translation>ミリメートルとして読むとスキャンの長さは%1 mmで、歯より大きくなります。</translation>
    </message>
    <message>
        <source>The file names no unit. As centimetres it is %1 mm long, so centimetres were taken.</source>
        <translation>ファイルに単位がありません。センチメートルなら長さ%1 mmなので、センチメートルとして読みました。</translation>
    </message>
    <message>
        <source>The file names no unit. As inches it is %1 mm long, so inches were taken.</source>
        <translation>このファイルには単位がありません。インチとして読むと長さが %1 mm になるため、インチとしました。</translation>
    </message>
    <message>
        <source>The file names no unit. As metres it is %1 mm long, so metres were taken.</source>
        <translation>ファイルに単位がありません。メートルなら長さ%1 mmなので、メートルとして読みました。</translation>
    </message>
    <message>
        <source>In no usual unit has the scan the size of a tooth, so it was made %1 mm long.</source>
        <translation>どの単位でも歯の大きさにならないため、長さ%1 mmにしました。</translation>
    </message>
    <message>
        <source>The tooth lay askew in the file and was turned upright. If it is not upright now, export it with the crown along +z.</source>
        <translation>ファイル内で歯が傾いていたため、まっすぐに直しました。正しい向きでない場合は、歯冠を +z に向けて書き出してください。</translation>
    </message>
    <message>
        <source>The shape does not show where the crown is. If the tooth lies on its side, export it with the crown along +z.</source>
        <translation>形から歯冠の位置が分かりません。歯が横向きの場合は、歯冠を+z方向にして書き出してください。</translation>
    </message>
    <message>
        <source>The scan has openings; they were closed.</source>
        <translation>スキャンに開口部があったため、閉じました。</translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) without an area were left out.</source>
        <translation>
            <numerusform>面積のない三角形%n個を除外しました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) are there twice.</source>
        <translation>
            <numerusform>三角形%n個が重複しています。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n edge(s) more than two triangles meet.</source>
        <translation>
            <numerusform>%n本の辺に3つ以上の三角形が接しています。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n edge(s) neighbouring triangles disagree which side is outside.</source>
        <translation>
            <numerusform>%n本の辺で隣り合う三角形の表裏が一致しません。</numerusform>
        </translation>
    </message>
    <message>
        <source>The scan was inside out and has been turned.</source>
        <translation>スキャンの裏表が逆だったため、反転しました。</translation>
    </message>
    <message numerus="yes">
        <source>The scan has %n separate part(s); the outermost surface counts.</source>
        <translation>
            <numerusform>スキャンは%n個の部分に分かれています。最も外側の表面を使います。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Section</name>
    <message>
        <source>ideal preparation</source>
        <translation>理想形</translation>
    </message>
    <message>
        <source>within tolerance</source>
        <extracomment>In the key of a picture: what may be cut or left without losing points</extracomment>
        <translation>許容範囲内</translation>
    </message>
    <message>
        <source>costs points</source>
        <extracomment>In the key of a picture: farther out, all points of this criterion are lost</extracomment>
        <translation>減点</translation>
    </message>
    <message>
        <source>The plane does not meet the tooth here.</source>
        <translation>この平面は歯と交わりません。</translation>
    </message>
    <message>
        <source>original surface</source>
        <extracomment>In the key of a picture, beside a line</extracomment>
        <translation>元の表面</translation>
    </message>
    <message>
        <source>soft decay</source>
        <translation>軟らかいう蝕</translation>
    </message>
    <message>
        <source>leathery decay</source>
        <translation>革様のう蝕</translation>
    </message>
    <message>
        <source>firm decay</source>
        <translation>硬いう蝕</translation>
    </message>
</context>
<context>
    <name>Surface</name>
    <message>
        <source>M</source>
        <extracomment>Letters for sides of teeth, one or two each. Mesial</extracomment>
        <translation>M</translation>
    </message>
    <message>
        <source>D</source>
        <extracomment>Letter for the distal side</extracomment>
        <translation>D</translation>
    </message>
    <message>
        <source>La</source>
        <extracomment>Letters for the labial side (towards the lip), then for the buccal one (towards the cheek)</extracomment>
        <translation>La</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>P</source>
        <extracomment>Letters for the palatal side, then for the lingual one</extracomment>
        <translation>P</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>I</source>
        <extracomment>Letters for the incisal edge, then for the occlusal surface</extracomment>
        <translation>I</translation>
    </message>
    <message>
        <source>O</source>
        <translation>O</translation>
    </message>
</context>
<context>
    <name>TimeLine</name>
    <message>
        <source>%1 pad: answer %2</source>
        <extracomment>%1 is &quot;Left&quot;, &quot;Middle&quot; or &quot;Right&quot;, %2 a tissue</extracomment>
        <translation>%1のパッド：%2と回答</translation>
    </message>
    <message>
        <source>Graded</source>
        <translation>採点</translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation>メモ%1</translation>
    </message>
    <message>
        <source>Undone</source>
        <translation>元に戻しました</translation>
    </message>
    <message>
        <source>Redone</source>
        <translation>やり直しました</translation>
    </message>
    <message>
        <source>Tooth reset</source>
        <translation>歯をリセット</translation>
    </message>
    <message>
        <source>Handpiece: %1</source>
        <translation>ハンドピース：%1</translation>
    </message>
    <message>
        <source>The hand was guided back</source>
        <translation>手を定位置へ導きました</translation>
    </message>
    <message>
        <source>Point %1 touched</source>
        <translation>点%1に接触</translation>
    </message>
    <message>
        <source>Resumed</source>
        <translation>再開</translation>
    </message>
    <message>
        <source>section</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>depth gauge</source>
        <translation>深さ計</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>X線</translation>
    </message>
    <message>
        <source>depth colours</source>
        <translation>深さの色分け</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>ミラー</translation>
    </message>
    <message>
        <source>ideal</source>
        <translation>理想形</translation>
    </message>
    <message>
        <source>colour of the bur</source>
        <translation>バーの色</translation>
    </message>
    <message>
        <source>guided hand</source>
        <translation>手の誘導</translation>
    </message>
    <message>
        <source>No aids in use</source>
        <translation>補助なし</translation>
    </message>
    <message>
        <source>Aids in use: %1</source>
        <translation>使用中の補助：%1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 who remarked something on an attempt, %2 the words</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Bur: %1</source>
        <extracomment>%1: a bur such as &quot;Pear, No. 330&quot;</extracomment>
        <translation>バー: %1</translation>
    </message>
</context>
<context>
    <name>Tooth</name>
    <message>
        <source>upper right</source>
        <translation>上顎右側</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>上顎左側</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>下顎左側</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>下顎右側</translation>
    </message>
    <message>
        <source>%1 central incisor</source>
        <translation>%1中切歯</translation>
    </message>
    <message>
        <source>%1 lateral incisor</source>
        <translation>%1側切歯</translation>
    </message>
    <message>
        <source>%1 canine</source>
        <translation>%1犬歯</translation>
    </message>
    <message>
        <source>%1 first premolar</source>
        <translation>%1第一小臼歯</translation>
    </message>
    <message>
        <source>%1 second premolar</source>
        <translation>%1第二小臼歯</translation>
    </message>
    <message>
        <source>%1 first molar</source>
        <translation>%1第一大臼歯</translation>
    </message>
    <message>
        <source>%1 second molar</source>
        <translation>%1第二大臼歯</translation>
    </message>
    <message>
        <source>%1 third molar</source>
        <translation>%1第三大臼歯</translation>
    </message>
    <message>
        <source>Tooth %1</source>
        <translation>歯 %1</translation>
    </message>
    <message>
        <source>Tooth without a name</source>
        <translation>名前のない歯</translation>
    </message>
</context>
<context>
    <name>ViewMarks</name>
    <message>
        <source>%1 mm</source>
        <extracomment>A length in millimetres</extracomment>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>as it should be</source>
        <translation>適正</translation>
    </message>
    <message>
        <source>%1 too deep</source>
        <extracomment>%1 is a length: the tooth is cut deeper than it should be</extracomment>
        <translation>%1深すぎ</translation>
    </message>
    <message>
        <source>%1 to cut</source>
        <extracomment>%1 is a length: so much is still to be taken away</extracomment>
        <translation>残り%1</translation>
    </message>
    <message>
        <source>deviation, mm</source>
        <extracomment>Titles of a scale of colours: how deep a cut is, and how far from the ideal</extracomment>
        <translation>偏差、mm</translation>
    </message>
    <message>
        <source>depth, mm</source>
        <translation>深さ、mm</translation>
    </message>
</context>
<context>
    <name>app::AdminController</name>
    <message>
        <source>The person was erased. The attempts stay as %1.</source>
        <translation>この人の情報を消去しました。試行は %1 として残ります。</translation>
    </message>
    <message>
        <source>The person was erased, and the attempts stay as %1. Another program was using the database file, so unused parts of it may contain the names until another person is erased.</source>
        <translation>この人の情報を消去しました。試行は %1 として残ります。別のプログラムがデータベースファイルを使用していたため、次に誰かの情報を消去するまで、ファイルの未使用部分に名前が残っている可能性があります。</translation>
    </message>
    <message>
        <source>%1 (not protected on the network: %2)</source>
        <translation>%1（ネットワーク上で保護されていません: %2）</translation>
    </message>
    <message>
        <source>%1 was entered.</source>
        <translation>%1 を登録しました。</translation>
    </message>
    <message>
        <source>%1 was changed.</source>
        <translation>%1 を変更しました。</translation>
    </message>
    <message>
        <source>%1 cannot be read, or is too large.</source>
        <translation>%1 を読めないか、大きすぎます。</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>中止しました。</translation>
    </message>
    <message>
        <source>The data are being backed up …</source>
        <translation>データをバックアップしています…</translation>
    </message>
    <message>
        <source>Everything is looked at …</source>
        <translation>すべてを確認しています…</translation>
    </message>
    <message>
        <source>Nothing is wrong: %1 attempts and %2 rows of the audit are as they were noted.</source>
        <translation>異常はありません：%1 件の試行と監査記録 %2 行は記録されたままです。</translation>
    </message>
    <message numerus="yes">
        <source>%n thing(s) are not as they should be.</source>
        <translation>
            <numerusform>%n 件の異常があります。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is empty. The first line of a class list names its columns: username, given_name, family_name, role, class.</source>
        <translation>%1は空です。名簿の1行目には列名（username, given_name, family_name, role, class）を書きます。</translation>
    </message>
    <message numerus="yes">
        <source>A place that was left is locked after %n minute(s).</source>
        <translation>
            <numerusform>離席すると%n分後にロックされます。</numerusform>
        </translation>
    </message>
    <message>
        <source>The backup is looked at …</source>
        <translation>バックアップを調べています…</translation>
    </message>
    <message>
        <source>%1 is no whole backup of a school, and was not restored. Choose another one.</source>
        <translation>%1は学校の完全なバックアップではないため、復元されませんでした。別のものを選んでください。</translation>
    </message>
    <message>
        <source>The class list is looked at …</source>
        <translation>名簿を調べています…</translation>
    </message>
    <message>
        <source>These people are being entered …</source>
        <translation>登録しています…</translation>
    </message>
    <message>
        <source>No class can be called that. Its name has 1 to 100 characters that can be seen, without |, which parts classes in a class list, and no other class has it.</source>
        <translation>その名前は付けられません。クラス名は見える文字で1～100文字、クラス名簿でクラスを区切る | を含まず、ほかのクラスと重ならないものにしてください。</translation>
    </message>
    <message>
        <source>%1 has more than %2 lines. Split it, and enter the parts one after another.</source>
        <translation>%1は%2行を超えています。分割して順に登録してください。</translation>
    </message>
    <message>
        <source>The audit is still the one that the report with the code %1 names.</source>
        <translation>監査記録は、コード %1 の報告書が示すものと同じです。</translation>
    </message>
    <message>
        <source>Backed up: %1. Its pages and keys are whole.</source>
        <translation>バックアップしました：%1。ページとキーに損傷はありません。</translation>
    </message>
    <message>
        <source>The school&apos;s file is in use: another window of Cusp, or another program, has it open, or a backup is being made. Close what has it open, and restore then.</source>
        <translation>学校のファイルは使用中です。Cuspの別のウィンドウか別のプログラムが開いているか、バックアップの作成中です。開いているものを閉じてから復元してください。</translation>
    </message>
    <message>
        <source>The backup was not restored; nothing has been changed. %1</source>
        <translation>バックアップは復元されませんでした。何も変更されていません。%1</translation>
    </message>
    <message>
        <source>It is no backup of this school.</source>
        <translation>この学校のバックアップではありません。</translation>
    </message>
    <message>
        <source>There is nothing to save: everything is as it was.</source>
        <translation>保存するものはありません。すべて元のままです。</translation>
    </message>
    <message>
        <source>Nothing was entered: somebody else has entered or changed people meanwhile. This is what the list would do now.</source>
        <translation>何も登録していません。その間に別の人が登録または変更しました。これが現在のリストの内容です。</translation>
    </message>
    <message>
        <source>That cannot be: the username is empty or taken, or has other characters than the letters a to z, digits and . _ - @.</source>
        <translation>変更できません。ユーザー名が空か使用済み、または英字a〜z、数字、. _ - @ 以外の文字が含まれています。</translation>
    </message>
</context>
<context>
    <name>app::LessonsController</name>
    <message>
        <source>The pack was not unpacked, so its lesson cannot be changed. %1</source>
        <translation>パックを展開できなかったため、課題を変更できません。%1</translation>
    </message>
    <message>
        <source>No program answers here that shows folders. Your own lessons are in %1.</source>
        <translation>フォルダーを表示するプログラムがここにはありません。ご自分の課題は %1 にあります。</translation>
    </message>
</context>
<context>
    <name>app::OpenedScoreController</name>
    <message>
        <source>Preparing the score card …</source>
        <translation>成績表を作成しています …</translation>
    </message>
    <message>
        <source>Earlier attempts are not available during an exam. Press G to finish the exam, or start another lesson.</source>
        <translation>試験中は以前の試行を開けません。Gで試験を終えるか、別の課題を始めてください。</translation>
    </message>
</context>
<context>
    <name>app::AttemptController</name>
    <message>
        <source>Making tooth %1 …</source>
        <translation>歯%1を作成しています …</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1を読み込んでいます …</translation>
    </message>
    <message>
        <source>Making a practice block …</source>
        <translation>練習ブロックを作成しています …</translation>
    </message>
    <message>
        <source>Preparing the lesson …</source>
        <translation>課題を準備しています …</translation>
    </message>
    <message>
        <source>The reference was saved as %1. A lesson names it, or choose it in the editor of a lesson on this tooth.</source>
        <translation>基準を%1として保存しました。課題で指定するか、この歯の課題のエディターで選んでください。</translation>
    </message>
</context>
<context>
    <name>app::ResumeController</name>
    <message>
        <source>Resuming the attempt …</source>
        <translation>試行を再開しています …</translation>
    </message>
    <message>
        <source>Your attempt continues where you stopped. It was begun with the mouse: the device has no soft limit at the end of its reach in this attempt.</source>
        <translation>中断したところから試みを続けます。マウスで始めた試みなので、この試みではデバイスの可動範囲の端に柔らかい限界はありません。</translation>
    </message>
    <message>
        <source>Your attempt continues where you stopped.</source>
        <translation>試行を中断したところから続けます。</translation>
    </message>
    <message>
        <source>The attempt is no longer there.</source>
        <translation>その試行はもうありません。</translation>
    </message>
</context>
<context>
    <name>app::GradingController</name>
    <message>
        <source>The tooth is not ready yet. Try again in a moment.</source>
        <translation>歯の準備ができていません。少し待ってからもう一度お試しください。</translation>
    </message>
    <message>
        <source>No pad has an answer yet. Choose below the view what each pad is made of.</source>
        <translation>まだどのパッドにも回答がありません。画面の下で、それぞれ何でできているかを選んでください。</translation>
    </message>
    <message>
        <source>This exercise has not been started yet, so there is nothing to grade.</source>
        <translation>この練習はまだ始まっていないため、採点するものがありません。</translation>
    </message>
    <message>
        <source>Nothing has been cut yet, so there is nothing to grade.</source>
        <translation>まだ何も切削していないため、採点するものがありません。</translation>
    </message>
    <message>
        <source>The grade that could not be saved is now saved.</source>
        <translation>保存できなかった採点結果が保存されました。</translation>
    </message>
</context>
<context>
    <name>app::PlaybackController</name>
    <message>
        <source>Reading %1 …</source>
        <translation>%1を読み込んでいます …</translation>
    </message>
    <message>
        <source>Preparing the lesson …</source>
        <translation>課題を準備しています …</translation>
    </message>
    <message>
        <source>The expert</source>
        <translation>エキスパート</translation>
    </message>
    <message>
        <source>A simulated hand does the lesson …</source>
        <translation>模擬の手が課題を行っています …</translation>
    </message>
    <message>
        <source>The simulated hand</source>
        <translation>模擬の手</translation>
    </message>
    <message>
        <source>No teacher has recorded this lesson, so a simulated hand shows it.</source>
        <translation>この課題の教員の記録がないため、模擬の手がお見せします。</translation>
    </message>
    <message>
        <source>No teacher has recorded this lesson, and the simulated hand cannot do it.</source>
        <translation>この課題の教員の記録がなく、模擬の手でもできません。</translation>
    </message>
    <message>
        <source>The tooth is intact. You can start drilling.</source>
        <translation>歯は元どおりです。切削を始められます。</translation>
    </message>
    <message>
        <source>You are back in your own work.</source>
        <translation>ご自身の作業に戻りました。</translation>
    </message>
</context>
<context>
    <name>app::LoginController</name>
    <message>
        <source>The school&apos;s database is on a network drive, where only one computer at a time can use it. For several computers, use a PostgreSQL server.</source>
        <translation>学校のデータベースはネットワークドライブ上にあり、同時に1台しか使えません。複数台ではPostgreSQLサーバーを使ってください。</translation>
    </message>
    <message>
        <source>The connection to the school&apos;s server is not protected: someone on the network can read or change names and marks. Ask whoever looks after the server.</source>
        <translation>学校のサーバーとの接続は保護されていません。ネットワーク上の誰かが、名前や成績を読んだり変えたりできます。サーバーの管理者に相談してください。</translation>
    </message>
    <message>
        <source>Your password was changed.</source>
        <translation>パスワードを変更しました。</translation>
    </message>
    <message>
        <source>This account was disabled, and you were logged out. Ask an admin.</source>
        <translation>このアカウントは無効にされ、ログアウトしました。管理者に尋ねてください。</translation>
    </message>
    <message>
        <source>Your role was changed, and you were logged out. Log in again.</source>
        <translation>役割が変更され、ログアウトしました。もう一度ログインしてください。</translation>
    </message>
    <message>
        <source>Your login has ended, or another school is now where yours was. Log in again.</source>
        <translation>ログインが終了したか、この学校のあった場所に別の学校があります。もう一度ログインしてください。</translation>
    </message>
</context>
<context>
    <name>app::SchoolController</name>
    <message>
        <source>An attempt does not match its recording, so its score does not count. It is marked in the student&apos;s attempts and in the table of the class.</source>
        <translation>記録と一致しない試行があり、その得点は数えられません。学生の試行とクラスの表に印が付いています。</translation>
    </message>
    <message>
        <source>The database is older than when this computer last used it: attempts and changes may be missing. If nobody restored a backup, somebody put an older copy in its place. The audit has a row about it.</source>
        <translation>データベースはこのコンピューターが最後に使ったときより古く、試行や変更が失われている可能性があります。バックアップを復元した人がいなければ、誰かが古いコピーに置き換えています。監査ログに記録があります。</translation>
    </message>
    <message>
        <source>Today&apos;s backup was not made. %1</source>
        <translation>今日のバックアップは作成されませんでした。%1</translation>
    </message>
    <message>
        <source>The backup was not restored; nothing has been changed. %1</source>
        <translation>バックアップは復元されませんでした。何も変更されていません。%1</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) on this computer cannot be sent to this school: the student is unknown, or another station.key signed them. They stay on this computer.</source>
        <translation>
            <numerusform>このコンピューターの試行%n件は、この学校に送れません。学生が不明か、別の station.key で署名されています。このコンピューターに残ります。</numerusform>
        </translation>
    </message>
    <message>
        <source>The backup of %1 was restored.</source>
        <extracomment>%2: a file&apos;s name</extracomment>
        <translation>%1 のバックアップを復元しました。</translation>
    </message>
    <message>
        <source>The backup of %1 was restored. The previous file is kept next to it as %2.</source>
        <translation>%1 のバックアップを復元しました。以前のファイルは %2 として隣に残ります。</translation>
    </message>
    <message>
        <source>The backup was not restored. %1</source>
        <translation>バックアップは復元されませんでした。%1</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) on this computer wait for another school: %1. If that is this one under an earlier name, &quot;cusp db send&quot; brings them here.</source>
        <extracomment>%1: a file&apos;s name, or the address of a server</extracomment>
        <translation>
            <numerusform>このコンピューターの%n件の試行は、別の学校（%1）を待っています。それが以前の名前のこの学校であれば、cusp の db send コマンドでここに送れます。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ReportController</name>
    <message>
        <source>Score card: %1</source>
        <translation>成績表：%1</translation>
    </message>
    <message>
        <source>Save the score card</source>
        <translation>成績表を保存</translation>
    </message>
    <message>
        <source>The score card was saved as %1.</source>
        <translation>成績表を %1 として保存しました。</translation>
    </message>
    <message>
        <source>The score card could not be written. Choose another folder, or free some disk space.</source>
        <translation>成績表を書き込めませんでした。別のフォルダーを選ぶか、ディスクの空きを増やしてください。</translation>
    </message>
    <message>
        <source>The score card was printed.</source>
        <translation>成績表を印刷しました。</translation>
    </message>
    <message>
        <source>The score card could not be printed.</source>
        <translation>成績表を印刷できませんでした。</translation>
    </message>
    <message>
        <source>Creating the score card …</source>
        <translation>成績表を作成しています …</translation>
    </message>
    <message>
        <source>Not logged in</source>
        <translation>未ログイン</translation>
    </message>
    <message>
        <source>There is no printer on this computer. Save it as a PDF instead.</source>
        <translation>このコンピューターにはプリンターがありません。代わりにPDFとして保存してください。</translation>
    </message>
</context>
<context>
    <name>app::DeviceController</name>
    <message>
        <source>This cannot be changed during an exam.</source>
        <translation>試験中は変更できません。</translation>
    </message>
    <message>
        <source>The %1 is ready again and moves the bur.</source>
        <extracomment>%1: a force device</extracomment>
        <translation>%1 は再び使えるようになり、バーを動かします。</translation>
    </message>
    <message>
        <source>The %1 no longer responds, and the bur was lifted. Continue with the mouse, or plug it in again.</source>
        <extracomment>%1: a force device</extracomment>
        <translation>%1 が応答しないため、バーを持ち上げました。マウスで続けるか、もう一度接続してください。</translation>
    </message>
    <message>
        <source>Show the device</source>
        <translation>デバイスを表示</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: a force device; %2: a sentence about its state</extracomment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>app::HeadTrackingController</name>
    <message>
        <source>Print the tag</source>
        <translation>マーカーの印刷</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF 文書 (*.pdf)</translation>
    </message>
    <message>
        <source>The sheet is in %1. Print it without scaling.</source>
        <extracomment>%1: a path</extracomment>
        <translation>シートを %1 に保存しました。拡大縮小せずに印刷してください。</translation>
    </message>
    <message>
        <source>The sheet could not be written.</source>
        <translation>シートを書き込めませんでした。</translation>
    </message>
    <message>
        <source>The field of view could not be measured. Hold the tag still at this distance, and check the edge of its black square.</source>
        <translation>画角を測定できませんでした。この距離でマーカーを静止させ、黒い正方形の辺の長さを確認してください。</translation>
    </message>
    <message>
        <source>The field of view is %1°. It is stored for this camera.</source>
        <extracomment>%1: a number of degrees</extracomment>
        <translation>画角は %1° です。このカメラ用に保存されます。</translation>
    </message>
    <message>
        <source>The view does not follow your head: the camera gives no pictures.</source>
        <translation>視点が頭に追従していません：カメラから画像が届きません。</translation>
    </message>
    <message>
        <source>The view does not follow your head: the tag is not seen.</source>
        <translation>視点が頭に追従していません：マーカーが見えません。</translation>
    </message>
    <message>
        <source>Show the device</source>
        <translation>デバイスを表示</translation>
    </message>
    <message>
        <source>The calibration %1 cannot be used. The field of view counts.</source>
        <extracomment>%1: the name of a file</extracomment>
        <translation>校正 %1 は使えません。画角の値を使います。</translation>
    </message>
</context>
<context>
    <name>app::AttemptHistoryController</name>
    <message>
        <source>The recording of this attempt is not there, so it cannot be shown again. Its score and its figures are in the list.</source>
        <translation>この試行の記録がないため、再表示できません。得点と数値は一覧にあります。</translation>
    </message>
    <message>
        <source>%1: %2 points</source>
        <extracomment>%1: a lesson, and when it was done</extracomment>
        <translation>%1：%2点</translation>
    </message>
    <message>
        <source>This belongs to none of your classes any more. An admin can enter you into the class again.</source>
        <translation>これはもうあなたのどのクラスのものでもありません。管理者がもう一度クラスに登録できます。</translation>
    </message>
</context>
<context>
    <name>app::ClassController</name>
    <message>
        <source>Save the class report</source>
        <translation>クラスの報告書を保存</translation>
    </message>
    <message>
        <source>The report was saved as %1.</source>
        <translation>報告書を %1 として保存しました。</translation>
    </message>
    <message>
        <source>The report could not be written. Choose another folder, or make room on the disk.</source>
        <translation>報告書を書き込めませんでした。別のフォルダーを選ぶか、ディスクの空きを増やしてください。</translation>
    </message>
    <message>
        <source>The report was printed.</source>
        <translation>報告書を印刷しました。</translation>
    </message>
    <message>
        <source>The printer did not take the report.</source>
        <translation>プリンターが報告書を受け付けませんでした。</translation>
    </message>
    <message>
        <source>The report is being written …</source>
        <translation>報告書を作成しています …</translation>
    </message>
    <message>
        <source>There is no printer on this computer. Save it as a PDF instead.</source>
        <translation>このコンピューターにはプリンターがありません。代わりにPDFとして保存してください。</translation>
    </message>
</context>
<context>
    <name>app::CommentsController</name>
    <message>
        <source>On the attempt of %1: %2</source>
        <extracomment>%1: who made an attempt, and when; %2: why</extracomment>
        <translation>%1の試行について：%2</translation>
    </message>
    <message>
        <source>That was not done: this student is in none of your classes any more. What you have typed stays here; an admin can enter you into the class again.</source>
        <translation>実行されませんでした：この学生はもうあなたのどのクラスにもいません。入力した内容はここに残ります。管理者がもう一度クラスに登録できます。</translation>
    </message>
</context>
<context>
    <name>app::PresetController</name>
    <message>
        <source>The next tooth feels like this.</source>
        <translation>次の歯からこの感触になります。</translation>
    </message>
    <message>
        <source>The next tooth of everybody here feels like this.</source>
        <translation>ここでは全員、次の歯からこの感触になります。</translation>
    </message>
    <message>
        <source>Not kept: only an admin keeps the school&apos;s presets.</source>
        <translation>保存していません：学校のプリセットを保存できるのは管理者だけです。</translation>
    </message>
    <message>
        <source>Not kept: %1</source>
        <translation>保存していません：%1</translation>
    </message>
    <message>
        <source>Not imported: %1</source>
        <translation>読み込んでいません：%1</translation>
    </message>
    <message>
        <source>The preset was exported as %1.</source>
        <translation>プリセットを %1 に書き出しました。</translation>
    </message>
    <message>
        <source>Not kept: the file cannot be written. Make room on the disk, or check the rights.</source>
        <translation>保存されませんでした。ファイルに書き込めません。ディスクの空きを作るか、権限を確認してください。</translation>
    </message>
    <message>
        <source>Not exported: the file cannot be written. Choose another folder, or make room on the disk.</source>
        <translation>書き出されませんでした。ファイルに書き込めません。別のフォルダを選ぶか、ディスクの空きを作ってください。</translation>
    </message>
    <message>
        <source>Somebody else has chosen %1 for everybody here meanwhile. That stays.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation>その間に別の人が全員用に %1 を選びました。それはそのままです。</translation>
    </message>
    <message>
        <source>%1 was not retired: teeth feel like it now, or too many are retired.</source>
        <translation>%1 は外せませんでした。今の歯の感触に使われているか、外したものが多すぎます。</translation>
    </message>
    <message>
        <source>%1 is offered to nobody any more. Attempts go on naming it.</source>
        <translation>%1 は今後だれにも表示されません。これまでの試行にはその名前が残ります。</translation>
    </message>
    <message>
        <source>%1 is offered again.</source>
        <translation>%1 はまた選べます。</translation>
    </message>
    <message>
        <source>The next tooth of everybody here feels like this. An admin had retired it; it is offered again.</source>
        <translation>ここでは全員、次の歯からこの感触になります。管理者が使用終了にしていましたが、再び使えるようになりました。</translation>
    </message>
</context>
<context>
    <name>ui::admin::AdminPage</name>
    <message>
        <source>People</source>
        <translation>人</translation>
    </message>
    <message>
        <source>Class list</source>
        <translation>クラス名簿</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>バックアップ</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>監査記録</translation>
    </message>
    <message>
        <source>This computer</source>
        <translation>このコンピューター</translation>
    </message>
    <message>
        <source>School</source>
        <translation>学校</translation>
    </message>
</context>
<context>
    <name>ui::admin::AuditPart</name>
    <message>
        <source>Clear the search</source>
        <translation>検索を消す</translation>
    </message>
    <message>
        <source>Search: a person, an action</source>
        <translation>検索：人、操作</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy the audit code</source>
        <translation>監査コードをコピー</translation>
    </message>
    <message>
        <source>Older rows</source>
        <translation>さらに古い行</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>監査記録</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n 行</numerusform>
        </translation>
    </message>
    <message>
        <source>No.</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>When</source>
        <translation>日時</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>誰が</translation>
    </message>
    <message>
        <source>What</source>
        <translation>何を</translation>
    </message>
    <message>
        <source>Whom or what</source>
        <translation>対象</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>Audit code now: %1. Every report shows the code of its day. Type one beside &quot;Check everything&quot; (Backups) to see whether what was noted before it is still as it was.</source>
        <extracomment>%1: a short code</extracomment>
        <translation>現在の監査コード：%1。各報告書にはその日のコードが載ります。「すべて確認」（バックアップ）の横に入力すると、それ以前の記録が元のままかどうか分かります。</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) among the newest %1; &quot;Older rows&quot; brings more to search</source>
        <extracomment>%1: how many rows were searched</extracomment>
        <translation>
            <numerusform>最新の %1 行のうち %n 行。さらに検索するには「さらに古い行」を押してください</numerusform>
        </translation>
    </message>
    <message>
        <source>Leave out attempts</source>
        <translation>試行を除く</translation>
    </message>
    <message>
        <source>Who began an exam or made an attempt is not shown: what is left is what was done to people, classes, grades, presets, settings and backups</source>
        <translation>試験の開始と試行は表示されません。人、クラス、成績、プリセット、設定、バックアップに対する操作だけが残ります</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) among the newest %1 without attempts; &quot;Older rows&quot; brings more to search</source>
        <extracomment>%1: how many rows were searched</extracomment>
        <translation>
            <numerusform>試行を除く最新の%1行のうち%n行。「古い行」を押すと検索範囲が広がります</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::admin::BackupPart</name>
    <message>
        <source>Back up now</source>
        <translation>今すぐバックアップ</translation>
    </message>
    <message>
        <source>Check everything</source>
        <translation>すべて確認</translation>
    </message>
    <message>
        <source>Look at every page, every attempt and the whole audit for what was changed, removed or inserted</source>
        <translation>すべてのページ、試行、監査記録について、変更・削除・挿入がないか調べます</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進行状況</translation>
    </message>
    <message>
        <source>What the check found</source>
        <translation>確認の結果</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>バックアップ</translation>
    </message>
    <message>
        <source>The school&apos;s data are on a server: %1. Its administrator makes the backups; &quot;cusp db copy&quot; brings all of it into a file.</source>
        <translation>学校のデータはサーバー %1 にあります。バックアップはサーバー管理者が行います。「cusp db」のコマンドで全体をファイルに写せます。</translation>
    </message>
    <message>
        <source>Yes: log everybody out and restore it</source>
        <translation>はい：全員ログアウトして復元する</translation>
    </message>
    <message>
        <source>Restore the chosen backup …</source>
        <translation>選んだバックアップを復元…</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>作成日時</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Keep what there is</source>
        <translation>今のままにする</translation>
    </message>
    <message>
        <source>The school&apos;s data are in %1. A backup is made every day the program is used. All of the last two days are kept, then one for each of 12 days, 10 weeks and 9 months.</source>
        <translation>学校のデータは %1 にあります。プログラムを使った日ごとにバックアップを作ります。最近2日分はすべて残し、その後は12日、10週、9か月のそれぞれに1つを残します。</translation>
    </message>
    <message>
        <source>Restore the backup of %1? What was entered after it will be missing. Attempts of this computer that are in no backup are entered again. The present file is kept beside it.</source>
        <extracomment>%1: when a backup was made</extracomment>
        <translation>%1のバックアップを復元しますか。それ以降に登録された内容は失われます。このコンピューターの試行のうち、どのバックアップにもないものは再び登録されます。現在のファイルは隣に残ります。</translation>
    </message>
    <message>
        <source>Audit code of a report (optional):</source>
        <translation>報告書の監査コード（任意）：</translation>
    </message>
    <message>
        <source>&quot;Check everything&quot; then also looks whether the audit is still the one that the report was printed from</source>
        <translation>「すべて確認」は、監査記録が報告書の印刷時と同じかどうかも調べます</translation>
    </message>
    <message>
        <source>This is no audit code. A report shows one such as %1.</source>
        <extracomment>%1: an example</extracomment>
        <translation>監査コードではありません。報告書には %1 のようなコードがあります。</translation>
    </message>
</context>
<context>
    <name>ui::admin::PeoplePart</name>
    <message>
        <source>Erase …</source>
        <translation>消去…</translation>
    </message>
    <message>
        <source>Erase the person</source>
        <translation>この人の情報を消去</translation>
    </message>
    <message>
        <source>Remove names, login and comments; the attempts stay under a pseudonym</source>
        <translation>名前、ログイン情報、コメントを消去します。試行は仮名で残ります</translation>
    </message>
    <message>
        <source>erased</source>
        <translation>消去済み</translation>
    </message>
    <message>
        <source>This person was erased. The attempts stay under this name.</source>
        <translation>この人の情報は消去されています。試行はこの名前で残っています。</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>検索を消す</translation>
    </message>
    <message>
        <source>Search: a name, a class, a role</source>
        <translation>検索：名前、クラス、役割</translation>
    </message>
    <message>
        <source>Username</source>
        <translation>ユーザー名</translation>
    </message>
    <message>
        <source>Given name</source>
        <translation>名</translation>
    </message>
    <message>
        <source>Family name</source>
        <translation>姓</translation>
    </message>
    <message>
        <source>Name of a class</source>
        <translation>クラスの名前</translation>
    </message>
    <message>
        <source>People</source>
        <translation>人</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>ログイン名</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>役割</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>クラス</translation>
    </message>
    <message>
        <source>Last login</source>
        <translation>最終ログイン</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>New person</source>
        <translation>新しい人</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>Add a class of this name</source>
        <translation>この名前のクラスを追加</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前変更</translation>
    </message>
    <message>
        <source>Give this name to the class that is chosen above</source>
        <translation>上で選んだクラスをこの名前にする</translation>
    </message>
    <message>
        <source>Reset password</source>
        <translation>パスワードをリセット</translation>
    </message>
    <message>
        <source>Take the password away and give a one-time code in its place</source>
        <translation>パスワードを消し、代わりにワンタイムコードを渡します</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Rename the class</source>
        <translation>クラス名を変更</translation>
    </message>
    <message>
        <source>Copy the one-time code</source>
        <translation>ワンタイムコードをコピー</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>無効</translation>
    </message>
    <message>
        <source>can log in</source>
        <translation>ログインできます</translation>
    </message>
    <message>
        <source>has a one-time code</source>
        <translation>ワンタイムコードあり</translation>
    </message>
    <message>
        <source>Enter the person</source>
        <translation>登録する</translation>
    </message>
    <message>
        <source>Save the changes</source>
        <translation>変更を保存</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>有効にする</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>無効にする</translation>
    </message>
    <message>
        <source>Who is disabled cannot log in; attempts and names stay</source>
        <translation>無効にするとログインできません。試行と名前は残ります</translation>
    </message>
    <message>
        <source>needs a one-time code</source>
        <translation>ワンタイムコードが必要</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>残す</translation>
    </message>
    <message>
        <source>Keep the password</source>
        <translation>パスワードを残す</translation>
    </message>
    <message>
        <source>Yes, take it away</source>
        <translation>はい、取り消す</translation>
    </message>
    <message>
        <source>Yes, take the password away</source>
        <translation>はい、パスワードを取り消す</translation>
    </message>
    <message>
        <source>%1 will need a new one-time code: take the password away?</source>
        <translation>%1 さんには新しいワンタイムコードが必要になります。パスワードを取り消しますか？</translation>
    </message>
    <message>
        <source>The school&apos;s data are being written to …</source>
        <translation>学校のデータに書き込んでいます…</translation>
    </message>
    <message numerus="yes">
        <source>%Ln person(s)</source>
        <translation>
            <numerusform>%Ln 人</numerusform>
        </translation>
    </message>
    <message>
        <source>What you have typed for a new person is not entered.</source>
        <translation>新しい人について入力した内容は登録されていません。</translation>
    </message>
    <message>
        <source>What you have changed of %1 is not saved.</source>
        <translation>%1 の変更は保存されていません。</translation>
    </message>
    <message>
        <source>has a one-time code, shown here</source>
        <translation>ワンタイムコードあり（ここで見られます）</translation>
    </message>
    <message>
        <source>There is a class %1 already. It is ticked above.</source>
        <extracomment>%1: the name of a class</extracomment>
        <translation>クラス「%1」はすでにあります。上で選択されています。</translation>
    </message>
    <message>
        <source>Yes, make another</source>
        <translation>はい、新しく作る</translation>
    </message>
    <message>
        <source>The one-time code of %1 above would let nobody in any longer: make another?</source>
        <translation>上の%1のワンタイムコードは使えなくなります。新しく作りますか？</translation>
    </message>
    <message>
        <source>The username is missing.</source>
        <translation>ユーザー名がありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n one-time code(s) are shown under School, and kept nowhere else: %1.</source>
        <extracomment>%1: a person, or several</extracomment>
        <translation>
            <numerusform>%n個のワンタイムコードは「学校」に表示されているだけで、ほかのどこにもありません：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Yes, save it</source>
        <translation>はい、保存する</translation>
    </message>
    <message>
        <source>Stay an admin</source>
        <translation>管理者のままにする</translation>
    </message>
    <message>
        <source>You would be an admin no longer, and be logged out: save it all the same?</source>
        <translation>あなたは管理者ではなくなり、ログアウトします。それでも保存しますか？</translation>
    </message>
    <message>
        <source>This is your own account. You would be logged out, and could not log in again: disable it?</source>
        <translation>これはあなた自身のアカウントです。ログアウトし、再びログインできなくなります。無効にしますか？</translation>
    </message>
    <message>
        <source>Yes, disable it</source>
        <translation>はい、無効にする</translation>
    </message>
    <message>
        <source>Somebody else has changed %1 meanwhile. What you have typed stays here.</source>
        <extracomment>%1 is a person</extracomment>
        <translation>その間に別の人が %1 を変更しました。入力した内容はここに残っています。</translation>
    </message>
    <message>
        <source>One-time code of %1. Tell it now: it is kept nowhere. It is shown here, whenever %1 is chosen, until you log out.</source>
        <translation>%1 のワンタイムコードです。今伝えてください。どこにも保存されません。ログアウトするまでは、%1 を選ぶたびにここに表示されます。</translation>
    </message>
</context>
<context>
    <name>ui::admin::RosterPart</name>
    <message>
        <source>A class list is a CSV file with the columns username, given_name, family_name, role and class. Role may be left out; several classes are parted by |. Choose it, or drop it here: nothing is entered before you have seen what it would do.</source>
        <translation>クラス名簿は username、given_name、family_name、role、class の列をもつCSVファイルです。role は省略でき、複数のクラスは縦棒で区切ります。選ぶか、ここにドロップしてください。内容を見るまで何も登録しません。</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>ファイルを選ぶ…</translation>
    </message>
    <message>
        <source>Enter these people</source>
        <translation>この人たちを登録する</translation>
    </message>
    <message>
        <source>Save the one-time codes …</source>
        <translation>ワンタイムコードを保存…</translation>
    </message>
    <message>
        <source>What the class list would do</source>
        <translation>名簿の内容</translation>
    </message>
    <message>
        <source>%1 was entered: %2 new, %3 known already. The codes below are kept nowhere else.</source>
        <translation>%1 を登録しました：新規 %2、既知 %3。下のコードはほかに保存されません。</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>列</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>ログイン名</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>One-time code</source>
        <translation>ワンタイムコード</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新規</translation>
    </message>
    <message>
        <source>known</source>
        <translation>登録済み</translation>
    </message>
    <message>
        <source>Choose a class list</source>
        <translation>クラス名簿を選ぶ</translation>
    </message>
    <message>
        <source>Class lists (*.csv);;All files (*)</source>
        <translation>クラス名簿 (*.csv);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Save the one-time codes</source>
        <translation>ワンタイムコードを保存</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>The codes were saved. Delete the file when everybody has logged in.</source>
        <translation>コードを保存しました。全員がログインしたらファイルを削除してください。</translation>
    </message>
    <message>
        <source>The codes could not be written. Choose another folder, or make room on the disk.</source>
        <translation>コードを書き込めませんでした。別のフォルダーを選ぶか、空きを増やしてください。</translation>
    </message>
    <message>
        <source>Example of a class list</source>
        <translation>クラス名簿の例</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>役割</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>クラス</translation>
    </message>
    <message>
        <source>%1 (new)</source>
        <extracomment>%1: a class that would be added</extracomment>
        <translation>%1（新規）</translation>
    </message>
    <message>
        <source>The one-time codes of %1 are not saved, and they are kept nowhere else.</source>
        <translation>%1のワンタイムコードは保存されておらず、ほかのどこにも残っていません。</translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln fault(s). Nothing was entered; mend the file and choose it again.</source>
        <translation>
            <numerusform>%1：%Ln 件の誤りがあります。何も登録していません。ファイルを直して選び直してください。</numerusform>
        </translation>
    </message>
    <message>
        <source>There is nobody in %1: it has only the line that names the columns.</source>
        <translation>%1 には誰もいません：列名の行だけです。</translation>
    </message>
    <message numerus="yes">
        <source>%1 %Ln new person(s) would be entered.</source>
        <extracomment>%1: what another sentence says of how many are known already</extracomment>
        <translation>
            <numerusform>%1新しく%Ln人が登録されます。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln person(s) known already.</source>
        <translation>
            <numerusform>%1：%Ln人はすでに登録済みです。</numerusform>
        </translation>
    </message>
    <message>
        <source>known as %1 so far</source>
        <translation>これまでの名前：%1</translation>
    </message>
    <message>
        <source>%1 was entered: nobody in it is new.</source>
        <translation>%1 を登録しました。新しい人はいません。</translation>
    </message>
    <message>
        <source>%1; the line has fewer fields than the first</source>
        <extracomment>%1: &quot;new&quot; or &quot;known&quot;, of somebody on a class list</extracomment>
        <translation>%1（この行の項目は1行目より少ない）</translation>
    </message>
    <message>
        <source>These people are being entered …</source>
        <translation>登録しています…</translation>
    </message>
</context>
<context>
    <name>ui::admin::StationPart</name>
    <message>
        <source>min</source>
        <translation>分</translation>
    </message>
    <message>
        <source>Minutes after which a place that was left is locked</source>
        <translation>離席後にロックするまでの分数</translation>
    </message>
    <message>
        <source>Drilled with</source>
        <translation>使う機器</translation>
    </message>
    <message>
        <source>Servo loop</source>
        <translation>サーボループ</translation>
    </message>
    <message>
        <source>Key of this station</source>
        <translation>この端末の鍵</translation>
    </message>
    <message>
        <source>Database</source>
        <translation>データベース</translation>
    </message>
    <message>
        <source>On their way</source>
        <translation>送信待ち</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>%1 times a second</source>
        <translation>毎秒 %1 回</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>%n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (pen)</source>
        <translation>%1（ペン）</translation>
    </message>
    <message>
        <source>a mouse</source>
        <translation>マウス</translation>
    </message>
    <message>
        <source>%1 ms in the middle, 99 of 100 within %2 ms</source>
        <extracomment>Times between two servo ticks</extracomment>
        <translation>中央値 %1 ms、100回中99回は %2 ms 以内</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>Found here</source>
        <translation>見つかった機器</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>測定値</translation>
    </message>
    <message>
        <source>Everywhere in the school, a place that was left is locked after</source>
        <translation>学校全体で、離席後にロックするまで</translation>
    </message>
</context>
<context>
    <name>ui::charts::ChartPanel</name>
    <message>
        <source>Save as picture (PNG) …</source>
        <translation>画像（PNG）として保存 …</translation>
    </message>
    <message>
        <source>Save as drawing (SVG) …</source>
        <translation>図（SVG）として保存 …</translation>
    </message>
    <message>
        <source>Save as table (CSV) …</source>
        <translation>表（CSV）として保存 …</translation>
    </message>
    <message>
        <source>Save this chart</source>
        <translation>このグラフを保存します</translation>
    </message>
    <message>
        <source>Save the chart &quot;%1&quot;</source>
        <translation>グラフ「%1」を保存</translation>
    </message>
    <message>
        <source>Save the chart</source>
        <translation>グラフを保存</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>保存しました：%1</translation>
    </message>
    <message>
        <source>%1 could not be written (%2). Try another folder.</source>
        <extracomment>%2: the system&apos;s own words</extracomment>
        <translation>%1に書き込めませんでした（%2）。別のフォルダーをお試しください。</translation>
    </message>
</context>
<context>
    <name>ui::charts::Table</name>
    <message>
        <source>series</source>
        <translation>系列</translation>
    </message>
    <message>
        <source>class, lower quartile</source>
        <translation>クラス、第1四分位</translation>
    </message>
    <message>
        <source>class, median</source>
        <translation>クラス、中央値</translation>
    </message>
    <message>
        <source>class, upper quartile</source>
        <translation>クラス、第3四分位</translation>
    </message>
    <message>
        <source>from</source>
        <translation>から</translation>
    </message>
    <message>
        <source>to</source>
        <translation>まで</translation>
    </message>
</context>
<context>
    <name>ui::console::Console</name>
    <message>
        <source>Console</source>
        <translation>コンソール</translation>
    </message>
    <message>
        <source>Answers of the console</source>
        <translation>コンソールの応答</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Type a command; Tab completes, &quot;help&quot; explains</source>
        <translation>コマンドを入力してください。Tabで補完、「help」で説明を表示します</translation>
    </message>
    <message>
        <source>Parameters can be looked at and turned here while you drill. &quot;help&quot; lists the commands.</source>
        <translation>切削しながらパラメーターを表示・変更できます。「help」でコマンドの一覧を表示します。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; wants a name behind it.</source>
        <translation>「%1」の後に名前が必要です。</translation>
    </message>
    <message>
        <source>Write &quot;set NAME VALUE&quot;, as in &quot;set force.stiffness 1.5&quot;.</source>
        <translation>「set force.stiffness 1.5」のように「set 名前 値」と入力してください。</translation>
    </message>
    <message>
        <source>Presets are not to be had here.</source>
        <translation>ここではプリセットを使えません。</translation>
    </message>
    <message>
        <source>There is no command &quot;%1&quot;. &quot;help&quot; lists those there are.</source>
        <translation>「%1」というコマンドはありません。「help」で一覧を表示します。</translation>
    </message>
    <message>
        <source>No parameter&apos;s name holds &quot;%1&quot;.</source>
        <translation>名前に「%1」を含むパラメーターはありません。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number.</source>
        <translation>「%1」は数値ではありません。</translation>
    </message>
    <message>
        <source>All that is felt is as the preset says.</source>
        <translation>手応えはすべてプリセットのとおりです。</translation>
    </message>
    <message>
        <source>There is room for %1. Take one away with &quot;unwatch NAME&quot;.</source>
        <translation>表示できるのは%1個までです。「unwatch 名前」で1つ消してください。</translation>
    </message>
    <message>
        <source>Page Up and Page Down turn over the answers, Up and Down what was typed.</source>
        <translation>Page Up／Page Down で応答を、上下キーで入力履歴をめくります。</translation>
    </message>
    <message>
        <source>Write &quot;export NAME FILE&quot;, as in &quot;export live.force force.csv&quot;.</source>
        <translation>「export 名前 ファイル」の形で入力してください。例: 「export live.force force.csv」</translation>
    </message>
    <message>
        <source>list [TEXT]      the parameters whose name holds the text
get NAME         its value, range and what it does
set NAME VALUE   sets it
reset [NAME]     sets it, or everything that is felt, back
watch NAME       shows it over the view
plot NAME        draws its last ten seconds over the view
export NAME FILE saves what is plotted: .csv, .svg or .png
unwatch [NAME]   takes it, or everything, away
save NAME        keeps what is felt as a hardness preset
load NAME        feels a hardness preset that is kept</source>
        <translation>list [文字列]    名前にその文字列を含むパラメーター
get 名前         値、範囲、働き
set 名前 値      値を設定します
reset [名前]     その値、または手応えすべてを元に戻します
watch 名前       画面に表示します
plot 名前        直近10秒を画面に描きます
export 名前 ファイル 描いたものを保存します: .csv、.svg、.png
unwatch [名前]   その表示、またはすべてを消します
save 名前        今の手応えを硬さのプリセットとして保存します
load 名前        保存済みの硬さのプリセットを使います</translation>
    </message>
    <message>
        <source>%1 is not plotted. &quot;plot %1&quot; begins it; then it can be saved.</source>
        <translation>%1 は描かれていません。「plot %1」で描き始めると、保存できるようになります。</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>%1 として保存しました。</translation>
    </message>
    <message>
        <source>There is a file %1 already; choose another name.</source>
        <translation>ファイル %1 は既にあります。別の名前を選んでください。</translation>
    </message>
</context>
<context>
    <name>ui::console::WatchPanel</name>
    <message>
        <source>Seconds before now</source>
        <translation>現在までの秒数</translation>
    </message>
</context>
<context>
    <name>ui::console::Words</name>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>a live value, to be read, watched or plotted</source>
        <translation>実測値（読み取り、表示、グラフ化ができます）</translation>
    </message>
    <message>
        <source>0 (off) or 1 (on)</source>
        <translation>0（オフ）または1（オン）</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <extracomment>%1 and %2 are numbers, %2 with a unit</extracomment>
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>There is no parameter &quot;%1&quot;. Type &quot;list&quot; for those there are.</source>
        <translation>「%1」というパラメーターはありません。「list」と入力すると一覧が表示されます。</translation>
    </message>
    <message>
        <source>%1 is a live value: it can be watched and plotted, not set.</source>
        <translation>%1は実測値です。表示とグラフ化はできますが、設定はできません。</translation>
    </message>
    <message>
        <source>%1 takes %2.</source>
        <translation>%1に設定できるのは%2です。</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>硬さ</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>マウスとキー</translation>
    </message>
    <message>
        <source>Live values</source>
        <translation>実測値</translation>
    </message>
    <message>
        <source>This cannot be changed here and now.</source>
        <translation>ここでは今、変更できません。</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>押す力</translation>
    </message>
    <message>
        <source>How hard the mouse button presses the bur against the tooth.</source>
        <translation>マウスボタンがバーを歯に押し当てる強さ。</translation>
    </message>
    <message>
        <source>Force that the hand is given.</source>
        <translation>手に与えられる力。</translation>
    </message>
    <message>
        <source>Depth of the bur&apos;s tip below the uncut surface.</source>
        <translation>切削前の表面からバー先端までの深さ。</translation>
    </message>
    <message>
        <source>Volume removed since the tooth was taken, undone or not.</source>
        <translation>この歯を始めてから除去した体積（元に戻した分も含む）。</translation>
    </message>
    <message>
        <source>Turns of the bur under its load.</source>
        <translation>負荷がかかったバーの回転数。</translation>
    </message>
    <message>
        <source>Periods of the servo that were missed since the start.</source>
        <translation>開始以降に逃したサーボの周期数。</translation>
    </message>
    <message>
        <source>Time between two ticks of the servo: half of the last second&apos;s were shorter.</source>
        <translation>サーボの周期の間隔：直近1秒の半分はこれより短い値です。</translation>
    </message>
    <message>
        <source>Time between two ticks of the servo: 99 in 100 of the last second&apos;s were shorter.</source>
        <translation>サーボの周期の間隔：直近1秒の100回中99回はこれより短い値です。</translation>
    </message>
    <message>
        <source>A blind comparison of two presets is running, so their values are hidden. &quot;End the comparison&quot; beside the tooth ends it.</source>
        <translation>2つのプリセットをブラインド比較中のため、値は表示されません。歯の横の「比較を終える」で終わります。</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>送り</translation>
    </message>
    <message>
        <source>How fast the bur goes down at most while you press.</source>
        <translation>押している間にバーが下がる最大の速さ。</translation>
    </message>
</context>
<context>
    <name>ui::devices::ButtonLights</name>
    <message>
        <source>No grip button is pressed</source>
        <translation>グリップのボタンは押されていません</translation>
    </message>
    <message>
        <source>Pressed: %1</source>
        <translation>押されているボタン：%1</translation>
    </message>
</context>
<context>
    <name>ui::devices::DevicesPage</name>
    <message>
        <source>Devices</source>
        <translation>デバイス</translation>
    </message>
    <message>
        <source>Loading the firmware</source>
        <translation>ファームウェアを読み込み中</translation>
    </message>
    <message>
        <source>Pull the grip out of the device as far as it goes, then push it straight in.</source>
        <extracomment>Of the grip of a force device</extracomment>
        <translation>グリップを装置から止まるまで引き出し、その後まっすぐ押し込んでください。</translation>
    </message>
    <message>
        <source>Each arm has to pass its index mark. If no ring fills, check that the mains adapter is plugged in.</source>
        <translation>どのアームも基準マークを通る必要があります。円が塗られないときは、電源アダプターが接続されているか確かめてください。</translation>
    </message>
    <message>
        <source>Mouse or pen</source>
        <translation>マウスまたはペン</translation>
    </message>
    <message>
        <source>Simulated hand</source>
        <translation>シミュレーションの手</translation>
    </message>
    <message>
        <source>Always ready.</source>
        <translation>いつでも使えます。</translation>
    </message>
    <message>
        <source>Drills by itself while you watch.</source>
        <translation>見ている間に自動で切削します。</translation>
    </message>
    <message>
        <source>The bur follows the pointer over the tooth and goes down while you press the button. You feel no force. Feed, depth stop and force are set beside the tooth.</source>
        <translation>バーは歯の上でポインターに従い、ボタンを押している間下がります。力は感じません。送り、深さストップ、力は歯の横で設定します。</translation>
    </message>
    <message>
        <source>A simulated hand with a simulated force device cuts the ideal preparation. When you start or leave it, the attempt begins anew. Its attempts are not saved.</source>
        <translation>シミュレーションの力覚デバイスを持つ手が理想の形成を切削します。始めるときと終えるときに、試みは最初からになります。その試みは保存されません。</translation>
    </message>
    <message>
        <source>Serial number %1.</source>
        <extracomment>%1: the number of a device</extracomment>
        <translation>シリアル番号 %1。</translation>
    </message>
    <message>
        <source>Practise</source>
        <extracomment>The button that leads back to the tooth</extracomment>
        <translation>練習する</translation>
    </message>
    <message>
        <source>Use: %1</source>
        <translation>使う：%1</translation>
    </message>
    <message>
        <source>Another one is plugged in too. To use that one, unplug this one.</source>
        <translation>もう 1 台接続されています。そちらを使うには、このデバイスを取り外してください。</translation>
    </message>
    <message>
        <source>Head tracking</source>
        <translation>ヘッドトラッキング</translation>
    </message>
    <message>
        <source>Pedal and gamepad</source>
        <translation>ペダルとゲームパッド</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>音</translation>
    </message>
    <message>
        <source>Hand and rest</source>
        <extracomment>A button that opens a guide: which hand works, and where it rests</extracomment>
        <translation>手と支え</translation>
    </message>
</context>
<context>
    <name>ui::devices::FirmwareCard</name>
    <message>
        <source>Firmware file</source>
        <translation>ファームウェアファイル</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>ファイルを選ぶ …</translation>
    </message>
    <message>
        <source>Choose the firmware file</source>
        <translation>ファームウェアファイルを選ぶ</translation>
    </message>
    <message>
        <source>None is chosen.</source>
        <translation>選ばれていません。</translation>
    </message>
    <message>
        <source>Unknown firmware, SHA-256 %1</source>
        <translation>不明なファームウェア、SHA-256 %1</translation>
    </message>
    <message>
        <source>Firmware (*.bin *.BIN);;All files (*)</source>
        <translation>ファームウェア (*.bin *.BIN);;すべてのファイル (*)</translation>
    </message>
</context>
<context>
    <name>ui::devices::ForceTest</name>
    <message>
        <source>Away</source>
        <translation>奥へ</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左へ</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右へ</translation>
    </message>
    <message>
        <source>Towards you</source>
        <translation>手前へ</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下へ</translation>
    </message>
    <message>
        <source>Push the hand: %1</source>
        <extracomment>%1: a direction, such as &quot;Left&quot;</extracomment>
        <translation>手を押す：%1</translation>
    </message>
</context>
<context>
    <name>ui::devices::HandList</name>
    <message>
        <source>Chosen</source>
        <translation>選択中</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>デバイス</translation>
    </message>
    <message>
        <source>%1, chosen</source>
        <translation>%1、選択中</translation>
    </message>
</context>
<context>
    <name>ui::devices::HeadTrackingCard</name>
    <message>
        <source>Follow my head</source>
        <translation>頭の動きに従う</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <extracomment>Of a picture: it looks like a mirror</extracomment>
        <translation>鏡のように表示</translation>
    </message>
    <message>
        <source>Straight ahead is here</source>
        <translation>ここを正面にする</translation>
    </message>
    <message>
        <source>No picture is saved or sent.</source>
        <translation>映像は保存も送信もされません。</translation>
    </message>
    <message>
        <source>The picture of the camera appears here when head tracking is on.</source>
        <translation>ヘッドトラッキングをオンにすると、ここにカメラの映像が表示されます。</translation>
    </message>
</context>
<context>
    <name>ui::devices::HomingMarks</name>
    <message numerus="yes">
        <source>%n of 3 arms homed</source>
        <translation>
            <numerusform>3 本のうち %n 本のアームが原点を通過</numerusform>
        </translation>
    </message>
    <message>
        <source>Top arm</source>
        <translation>上のアーム</translation>
    </message>
    <message>
        <source>Right arm</source>
        <translation>右のアーム</translation>
    </message>
    <message>
        <source>Left arm</source>
        <translation>左のアーム</translation>
    </message>
</context>
<context>
    <name>ui::devices::IntervalChart</name>
    <message>
        <source>Intervals between answers</source>
        <translation>応答の間隔</translation>
    </message>
    <message>
        <source>Number of answers in the last second for each interval. The last bar contains all longer intervals. The height is logarithmic, so that a single late answer is visible.</source>
        <translation>直前の 1 秒の応答が、それぞれどの間隔で来たか。最後の棒はそれより長いものすべてです。遅れた応答が一つでも見えるように、高さは対数です。</translation>
    </message>
    <message>
        <source>%1 answers in a second</source>
        <translation>1 秒に %1 回の応答</translation>
    </message>
</context>
<context>
    <name>ui::devices::LiveTest</name>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Grip buttons</source>
        <translation>グリップのボタン</translation>
    </message>
    <message>
        <source>Force: hold a button, and the device pushes your hand gently</source>
        <translation>力：ボタンを押している間、デバイスが手を軽く押します</translation>
    </message>
    <message>
        <source>Intervals between answers</source>
        <translation>応答の間隔</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>応答</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>往復時間</translation>
    </message>
    <message>
        <source>99 % below</source>
        <extracomment>Of the time from a request to its answer: 99 of 100 are shorter</extracomment>
        <translation>99 % がこれ未満</translation>
    </message>
    <message>
        <source>Lost</source>
        <extracomment>Requests without an answer</extracomment>
        <translation>損失</translation>
    </message>
    <message>
        <source>Rejected</source>
        <extracomment>Answers that were not plausible</extracomment>
        <translation>破棄</translation>
    </message>
</context>
<context>
    <name>ui::devices::PlacementPicture</name>
    <message>
        <source>It stands on its base, and the arms point away from its front.</source>
        <translation>台の上に立ち、アームは前面から前へ向きます。</translation>
    </message>
    <message>
        <source>It lies on its back, and the arms point up.</source>
        <translation>背面を下にして寝かせ、アームは上を向きます。</translation>
    </message>
    <message>
        <source>It stands at your right hand and faces left.</source>
        <translation>右手側にあり、左を向きます。</translation>
    </message>
    <message>
        <source>It stands at your left hand and faces right.</source>
        <translation>左手側にあり、右を向きます。</translation>
    </message>
    <message>
        <source>It stands in front of you and faces you.</source>
        <translation>正面にあり、こちらを向きます。</translation>
    </message>
    <message>
        <source>How to place the device</source>
        <translation>デバイスの置き方</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>横から</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>上から</translation>
    </message>
</context>
<context>
    <name>ui::devices::PositionView</name>
    <message>
        <source>Position: %1 mm right, %2 mm away, %3 mm up</source>
        <extracomment>%1, %2, %3: millimetres to the right, away from the user and up</extracomment>
        <translation>位置：右へ %1 mm、奥へ %2 mm、上へ %3 mm</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>上から</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>正面から</translation>
    </message>
</context>
<context>
    <name>ui::devices::RuleCard</name>
    <message>
        <source>Copy the rule</source>
        <translation>ルールをコピー</translation>
    </message>
    <message>
        <source>Rule for this device</source>
        <translation>このデバイスのルール</translation>
    </message>
    <message>
        <source>As an administrator, write this rule to the file %1. Then unplug the device and plug it in again. The command &quot;%2&quot; prints the same rule.</source>
        <extracomment>%1: a file; %2: a command</extracomment>
        <translation>管理者として、このルールをファイル %1 に書き込んでください。その後、デバイスを抜いて、もう一度差し込んでください。コマンド「%2」も同じルールを出力します。</translation>
    </message>
</context>
<context>
    <name>ui::devices::SetupCard</name>
    <message>
        <source>It stands</source>
        <extracomment>How the device is placed on the table</extracomment>
        <translation>立て方</translation>
    </message>
    <message>
        <source>as sold</source>
        <extracomment>Of a device: on its base, as it was sold</extracomment>
        <translation>販売時のまま</translation>
    </message>
    <message>
        <source>on its back, arms up</source>
        <translation>寝かせて、アームは上</translation>
    </message>
    <message>
        <source>Place</source>
        <extracomment>Where the device stands, seen by the user</extracomment>
        <translation>場所</translation>
    </message>
    <message>
        <source>in front of you</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>on your right</source>
        <translation>右側</translation>
    </message>
    <message>
        <source>on your left</source>
        <translation>左側</translation>
    </message>
    <message>
        <source>Scale</source>
        <extracomment>How far the hand moves for one millimetre of the bur</extracomment>
        <translation>倍率</translation>
    </message>
    <message>
        <source>Movement of the hand for 1 mm of the bur, in millimetres</source>
        <translation>バーの 1 mm に対する手の動き（ミリメートル）</translation>
    </message>
</context>
<context>
    <name>ui::devices::TagSheet</name>
    <message>
        <source>Head tracking: tag %1</source>
        <translation>ヘッドトラッキング：タグ %1</translation>
    </message>
    <message>
        <source>Print this on matte paper. Cut a tag out along the dashed line. Do not cut off its white border: without it the tag is not found. Glue the tag to a piece of stiff, flat card.</source>
        <translation>つや消しの紙に印刷してください。破線に沿ってタグを切り取ります。白い縁は切り落とさないでください。縁がないとタグは検出されません。タグを硬く平らな厚紙に貼ってください。</translation>
    </message>
    <message>
        <source>Wear the tag on your forehead with the arrow pointing up, tilted by 15 to 25 degrees: its lower edge is nearer to the camera than its upper edge.</source>
        <translation>矢印を上にしてタグを額に付け、15～25 度傾けてください。下の縁が上の縁よりカメラに近くなるようにします。</translation>
    </message>
    <message>
        <source>Tell Cusp the length of the tag&apos;s edge. It stands below the tag and is the side of the black square.</source>
        <translation>タグの辺の長さを Cusp に指定してください。長さはタグの下に書かれており、黒い正方形の一辺です。</translation>
    </message>
    <message>
        <source>Tag %1, edge %2 mm</source>
        <translation>タグ %1、辺 %2 mm</translation>
    </message>
    <message>
        <source>The headband: cut it out and cut its two slots. Pull an elastic band, 20 mm wide and about 35 cm long, through the slots.</source>
        <translation>ヘッドバンド：切り取り、2 つの切れ込みを入れます。幅 20 mm、長さ約 35 cm のゴムバンドを切れ込みに通してください。</translation>
    </message>
    <message>
        <source>The wedge: glue it to stiff card, cut it out, fold it along the dotted lines to a triangle, and glue its flap to its foot. Glue it behind the tag, the foot below. It keeps the tag flat and tilts it by 20 degrees.</source>
        <translation>くさび：硬い厚紙に貼って切り取り、点線で折って三角形にし、のりしろを底面に貼ります。底面を下にしてタグの裏に貼ってください。タグを平らに保ち、20 度傾けます。</translation>
    </message>
    <message>
        <source>Flap</source>
        <translation>のりしろ</translation>
    </message>
    <message>
        <source>This side to the forehead</source>
        <translation>この面を額側に</translation>
    </message>
    <message>
        <source>This side to the tag</source>
        <translation>この面をタグ側に</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>底面</translation>
    </message>
    <message>
        <source>Board for the calibration of a camera. Glue it to something stiff and flat. Show it to the camera at many places and tilted to all sides.</source>
        <translation>カメラの校正用ボード。硬く平らな物に貼ってください。さまざまな位置で、いろいろな方向に傾けてカメラに見せてください。</translation>
    </message>
    <message>
        <source>Measure this line: it must be 100 mm long. Otherwise print without scaling (100 %).</source>
        <translation>この線を測ってください。長さは 100 mm のはずです。違うときは拡大縮小なし（100 %）で印刷してください。</translation>
    </message>
</context>
<context>
    <name>ui::devices::TagPicture</name>
    <message>
        <source>Picture of the camera, with the tag outlined</source>
        <translation>カメラの映像。マーカーは枠で囲まれています</translation>
    </message>
    <message>
        <source>Picture of the camera, without the tag</source>
        <translation>カメラの映像。マーカーはありません</translation>
    </message>
</context>
<context>
    <name>ui::devices::TrackingFigures</name>
    <message>
        <source>Pictures per second</source>
        <translation>1 秒あたりの画像</translation>
    </message>
    <message>
        <source>Pictures with the tag</source>
        <extracomment>Share of the pictures in which the tag was found</extracomment>
        <translation>マーカーのある画像</translation>
    </message>
    <message>
        <source>Time to find it</source>
        <translation>検出時間</translation>
    </message>
    <message>
        <source>Latency</source>
        <extracomment>Time from a picture of the camera to the turn of the view</extracomment>
        <translation>遅延</translation>
    </message>
    <message>
        <source>Jitter</source>
        <extracomment>How far the measured place of a head at rest moves</extracomment>
        <translation>揺れ</translation>
    </message>
</context>
<context>
    <name>ui::devices::TrackingSetupCard</name>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Size of its pictures</source>
        <translation>画像の大きさ</translation>
    </message>
    <message>
        <source>Its field of view, sideways</source>
        <translation>水平の画角</translation>
    </message>
    <message>
        <source>60° fits most cameras. The data sheet of the camera has the exact number.</source>
        <translation>ほとんどのカメラでは 60° で十分です。正確な値はカメラの仕様書にあります。</translation>
    </message>
    <message>
        <source>Number of the tag</source>
        <translation>マーカーの番号</translation>
    </message>
    <message>
        <source>Edge of its black square</source>
        <translation>黒い正方形の一辺</translation>
    </message>
    <message>
        <source>Turn of the view for 1° of the head</source>
        <translation>頭 1° あたりの視点の回転</translation>
    </message>
    <message>
        <source>Print the tag …</source>
        <translation>マーカーを印刷…</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <extracomment>%1: a number</extracomment>
        <translation>カメラ %1</translation>
    </message>
    <message>
        <source>No camera is plugged in</source>
        <translation>カメラが接続されていません</translation>
    </message>
    <message>
        <source>Camera %1, not plugged in</source>
        <extracomment>%1: the number of a camera</extracomment>
        <translation>カメラ %1（未接続）</translation>
    </message>
    <message>
        <source>A video file …</source>
        <translation>動画ファイル…</translation>
    </message>
    <message>
        <source>Choose a video file</source>
        <translation>動画ファイルを選択</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.webm *.ogv);;All files (*)</source>
        <translation>動画 (*.mp4 *.mkv *.avi *.mov *.webm *.ogv);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>When the head moves</source>
        <translation>頭を動かしたとき</translation>
    </message>
    <message>
        <source>The tooth turns</source>
        <translation>歯が回転する</translation>
    </message>
    <message>
        <source>The screen is a window</source>
        <extracomment>The tooth is seen through the screen as through a window</extracomment>
        <translation>画面が窓になる</translation>
    </message>
    <message>
        <source>Hold the tag %1 mm from the lens</source>
        <extracomment>%1: a length in millimetres</extracomment>
        <translation>マーカーをレンズから %1 mm に持つ</translation>
    </message>
    <message>
        <source>Measure the field of view</source>
        <translation>画角を測定</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>毎秒の枚数</translation>
    </message>
    <message>
        <source>Its lens</source>
        <translation>レンズ</translation>
    </message>
    <message>
        <source>By its field of view</source>
        <translation>画角による</translation>
    </message>
    <message>
        <source>A calibration file …</source>
        <translation>校正ファイル …</translation>
    </message>
    <message>
        <source>A folder of images …</source>
        <translation>画像のフォルダー …</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>画像のフォルダーを選ぶ</translation>
    </message>
    <message>
        <source>Choose a calibration of the camera</source>
        <translation>カメラの校正を選ぶ</translation>
    </message>
    <message>
        <source>Calibrations (*.json);;All files (*)</source>
        <translation>校正 (*.json);;すべてのファイル (*)</translation>
    </message>
</context>
<context>
    <name>ui::devices::TrackingText</name>
    <message>
        <source>Not available: head tracking is left out of this program.</source>
        <translation>利用できません：このプログラムにヘッドトラッキングは含まれていません。</translation>
    </message>
    <message>
        <source>Off.</source>
        <extracomment>Of head tracking</extracomment>
        <translation>オフ。</translation>
    </message>
    <message>
        <source>The camera is being opened.</source>
        <translation>カメラを開いています。</translation>
    </message>
    <message>
        <source>The camera sends no pictures.</source>
        <translation>カメラから映像が届きません。</translation>
    </message>
    <message>
        <source>The pictures are dark.</source>
        <translation>映像が暗すぎます。</translation>
    </message>
    <message>
        <source>The pictures do not change.</source>
        <translation>映像が変化しません。</translation>
    </message>
    <message>
        <source>Several tags with the number %1 are in the picture.</source>
        <extracomment>%1: a number</extracomment>
        <translation>番号 %1 のマーカーが複数映っています。</translation>
    </message>
    <message>
        <source>The view follows your head.</source>
        <translation>視点が頭の動きに従っています。</translation>
    </message>
    <message>
        <source>The tag is not in the picture.</source>
        <translation>マーカーが映っていません。</translation>
    </message>
    <message>
        <source>Install the libraries AprilTag and OpenCV and build Cusp again, or use a package that has them. The mouse turns the view without them.</source>
        <translation>ライブラリ AprilTag と OpenCV をインストールして Cusp をビルドし直すか、それらを含むパッケージを使ってください。それらがなくても、マウスで視点を回せます。</translation>
    </message>
    <message>
        <source>The view turns when you move your head. Print the tag, glue it to stiff card and wear it on a headband, tilted by about 20°. Then turn on “Follow my head”.</source>
        <translation>頭を動かすと視点が回ります。マーカーを印刷して厚紙に貼り、約 20° 傾けてヘッドバンドに付けてください。その後「頭の動きに従う」をオンにします。</translation>
    </message>
    <message>
        <source>This takes a few seconds at most.</source>
        <translation>長くても数秒で終わります。</translation>
    </message>
    <message>
        <source>%1 Cusp tries again by itself. The mouse turns the view meanwhile.</source>
        <extracomment>%1: what went wrong and what to do, one or two sentences</extracomment>
        <translation>%1Cusp は自動でもう一度試します。その間はマウスで視点を回せます。</translation>
    </message>
    <message>
        <source>Turn on more light, and check that no cover is in front of the camera.</source>
        <translation>照明を明るくし、カメラにカバーが付いていないか確かめてください。</translation>
    </message>
    <message>
        <source>Unplug the camera and plug it in again, or choose another one.</source>
        <translation>カメラを抜いて差し直すか、別のカメラを選んでください。</translation>
    </message>
    <message>
        <source>The view follows the largest one. Take the others out of the picture.</source>
        <translation>視点は最も大きいマーカーに従います。ほかのマーカーを映像の外に移してください。</translation>
    </message>
    <message>
        <source>Sit as you do when you drill, look at the screen, and press “Straight ahead is here”.</source>
        <translation>切削するときの姿勢で座り、画面を見て、「ここを正面にする」を押してください。</translation>
    </message>
    <message>
        <source>Turn to the camera so that the whole tag and its white border are in the picture. The tag must have the number %1. A lamp or a window behind you makes it too dark.</source>
        <extracomment>%1: a number; the button &quot;Print the tag …&quot; is on the same page</extracomment>
        <translation>マーカー全体と白い縁が映像に入るように、カメラの方を向いてください。マーカーの番号は %1 でなければなりません。後ろに照明や窓があると、マーカーが暗くなりすぎます。</translation>
    </message>
    <message>
        <source>The pictures are being opened.</source>
        <translation>映像を開いています。</translation>
    </message>
    <message>
        <source>The pictures cannot be read.</source>
        <translation>映像を読み込めません。</translation>
    </message>
    <message>
        <source>The last picture has been shown.</source>
        <translation>最後の画像まで表示しました。</translation>
    </message>
    <message>
        <source>To see the pictures again, turn “Follow my head” off and on.</source>
        <translation>もう一度見るには、「頭の動きに従う」をオフにしてからオンにしてください。</translation>
    </message>
    <message>
        <source>Choose other pictures, or a camera.</source>
        <translation>別の映像かカメラを選んでください。</translation>
    </message>
    <message>
        <source>The pictures are nearly white.</source>
        <translation>映像がほとんど真っ白です。</translation>
    </message>
    <message>
        <source>Turn the camera away from lamps and windows, or lower its exposure.</source>
        <translation>カメラを照明や窓から離れた方へ向けるか、露出を下げてください。</translation>
    </message>
    <message>
        <source>The camera gives %1 pictures a second, not %2: in little light it exposes for longer. Turn on more light, or choose smaller pictures.</source>
        <extracomment>%1 and %2: numbers</extracomment>
        <translation>カメラの映像は毎秒 %2 枚ではなく %1 枚です。暗いと露光時間が長くなります。照明を明るくするか、小さいサイズを選んでください。</translation>
    </message>
</context>
<context>
    <name>ui::devices::Words</name>
    <message>
        <source>Not available: this program was built without force devices.</source>
        <translation>使えません：このプログラムは力覚デバイスなしでビルドされています。</translation>
    </message>
    <message>
        <source>Not plugged in.</source>
        <translation>接続されていません。</translation>
    </message>
    <message>
        <source>Plugged in, but you are not allowed to open it.</source>
        <translation>接続されていますが、開く権限がありません。</translation>
    </message>
    <message>
        <source>Plugged in, but it cannot be opened.</source>
        <translation>接続されていますが、開けません。</translation>
    </message>
    <message>
        <source>Plugged in. It needs its firmware file.</source>
        <translation>接続されています。ファームウェアファイルが必要です。</translation>
    </message>
    <message>
        <source>Loading the firmware: %1 %.</source>
        <extracomment>%1: a number from 0 to 100</extracomment>
        <translation>ファームウェアを読み込み中：%1 %。</translation>
    </message>
    <message>
        <source>Plugged in. Move the grip to home it.</source>
        <translation>接続されています。グリップを動かして原点を合わせてください。</translation>
    </message>
    <message>
        <source>Ready.</source>
        <translation>準備完了。</translation>
    </message>
    <message>
        <source>It does not respond. The force is off.</source>
        <translation>応答しません。力は切れています。</translation>
    </message>
    <message>
        <source>Install the library libusb and build Cusp again, or use a package that has it.</source>
        <translation>ライブラリ libusb をインストールして Cusp をビルドし直すか、それを含むパッケージを使ってください。</translation>
    </message>
    <message>
        <source>Plug in the USB cable and the mains adapter. The device is found by itself.</source>
        <translation>USB ケーブルと電源アダプターを接続してください。デバイスは自動で見つかります。</translation>
    </message>
    <message>
        <source>The firmware came with the software of the device and may not be shipped with Cusp.</source>
        <translation>ファームウェアはデバイスのソフトウェアに付属し、Cusp と一緒には配布できません。</translation>
    </message>
    <message>
        <source>Check both plugs. The device continues by itself when it responds again.</source>
        <translation>両方のプラグを確かめてください。応答が戻れば自動で続きます。</translation>
    </message>
    <message>
        <source>The last problem, which is over: %1</source>
        <extracomment>%1: what went wrong, a sentence</extracomment>
        <translation>直前の問題（解決済み）：%1</translation>
    </message>
    <message>
        <source>Drill</source>
        <extracomment>A button on the grip of a force device; pressed, the bur turns</extracomment>
        <translation>切削</translation>
    </message>
    <message>
        <source>Undo</source>
        <extracomment>A button on the grip of a force device</extracomment>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Mirror</source>
        <extracomment>A button on the grip of a force device: the dental mirror</extracomment>
        <translation>ミラー</translation>
    </message>
    <message>
        <source>Centre</source>
        <extracomment>A button on the grip of a force device: back over the tooth</extracomment>
        <translation>中央へ</translation>
    </message>
    <message>
        <source>The calibration in %1 cannot be used, so the usual values are. Calibrate the device again.</source>
        <extracomment>%1: a path</extracomment>
        <translation>%1 の校正は使用できないため、標準値を使用します。デバイスをもう一度校正してください。</translation>
    </message>
</context>
<context>
    <name>ui::inside::SectionView</name>
    <message>
        <source>Section through the bur</source>
        <translation>バーを通る断面</translation>
    </message>
    <message>
        <source>Picture of the section</source>
        <translation>断面の画像</translation>
    </message>
    <message>
        <source>Cut the tooth in this direction, through the bur</source>
        <translation>バーを通り、この方向で歯を切った断面を表示します</translation>
    </message>
    <message>
        <source>Angle of the section, degrees</source>
        <translation>断面の角度（度）</translation>
    </message>
    <message>
        <source>Turn the section about the bur (Shift+X: by 15 degrees)</source>
        <translation>バーを中心に断面を回します（Shift+X：15度ずつ）</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Depth below original surface</source>
        <translation>元の表面からの深さ</translation>
    </message>
    <message>
        <source>Vertical depth of the tip below the original surface.</source>
        <translation>元の表面から先端までの垂直の深さです。</translation>
    </message>
    <message>
        <source>Dentin left over the pulp</source>
        <translation>歯髄上に残る象牙質</translation>
    </message>
    <message>
        <source>Sound dentin between the cut and the pulp straight below the tip. A dash: no pulp there.</source>
        <translation>先端の真下で、切削面と歯髄の間にある健全象牙質です。ダッシュ：そこに歯髄はありません。</translation>
    </message>
    <message>
        <source>Tip straight down to the pulp</source>
        <translation>先端から真下の歯髄まで</translation>
    </message>
    <message>
        <source>Straight down from the tip of the bur. A dash: no pulp there.</source>
        <translation>バーの先端から真下の距離です。ダッシュ：そこに歯髄はありません。</translation>
    </message>
    <message>
        <source>Bur to the nearest pulp</source>
        <translation>バーから最も近い歯髄まで</translation>
    </message>
    <message>
        <source>The shortest way in any direction, also out of the plane of the picture.</source>
        <translation>あらゆる方向での最短距離です。画面の平面外も含みます。</translation>
    </message>
    <message>
        <source>Section along y</source>
        <translation>y方向の断面</translation>
    </message>
    <message>
        <source>Section along x</source>
        <translation>x方向の断面</translation>
    </message>
    <message>
        <source>Section: %1</source>
        <translation>断面：%1</translation>
    </message>
</context>
<context>
    <name>ui::inside::XrayPage</name>
    <message>
        <source>Before</source>
        <translation>術前</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>X線</translation>
    </message>
    <message>
        <source>X-ray: %1</source>
        <extracomment>%1 is &quot;Tooth 36&quot; or a file name</extracomment>
        <translation>X線：%1</translation>
    </message>
    <message>
        <source>The crown between two sound neighbours made by Cusp, with contact points.</source>
        <translation>両隣在歯の間の歯冠です。隣在歯はCuspが作った健全歯で、接触しています。</translation>
    </message>
    <message>
        <source>Nothing in a scan says which side is mesial, so it gets no neighbours.</source>
        <translation>スキャンからは近心側が分からないため、隣在歯は付きません。</translation>
    </message>
    <message>
        <source>One tooth</source>
        <translation>1歯</translation>
    </message>
    <message>
        <source>The whole tooth with its root</source>
        <translation>歯根を含む歯全体</translation>
    </message>
    <message>
        <source>Bitewing</source>
        <translation>咬翼法</translation>
    </message>
    <message>
        <source>Beam from the side</source>
        <translation>側方からの照射角</translation>
    </message>
    <message>
        <source>Turns the beam about the tooth</source>
        <translation>歯を中心に照射方向を回します</translation>
    </message>
    <message>
        <source>Beam from above</source>
        <translation>上方からの照射角</translation>
    </message>
    <message>
        <source>Tilts the beam; 0 is level</source>
        <translation>照射方向を傾けます。0で水平です</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>露出</translation>
    </message>
    <message>
        <source>More radiation: a darker film with less grain</source>
        <translation>線量を増やす：フィルムは暗く、粒状は少なくなります</translation>
    </message>
    <message>
        <source>Simulated: a parallel beam, no scatter, no bone and no gums.</source>
        <translation>シミュレーション：平行線束、散乱なし、骨と歯肉なし。</translation>
    </message>
    <message>
        <source>Save the picture …</source>
        <translation>画像を保存 …</translation>
    </message>
    <message>
        <source>Save both films side by side as a PNG file</source>
        <translation>2枚のフィルムを並べてPNGファイルに保存します</translation>
    </message>
    <message>
        <source>This tooth lies on a side, so it gets no neighbours.</source>
        <translation>この歯は横向きなので、隣在歯は付きません。</translation>
    </message>
</context>
<context>
    <name>ui::people::AssignPage</name>
    <message>
        <source>Assign version %1 to new attempts</source>
        <translation>新しい試行に版%1を割り当てる</translation>
    </message>
    <message>
        <source>Assign the changed lesson to new attempts</source>
        <translation>新しい試行に変更後の課題を割り当てる</translation>
    </message>
    <message numerus="yes">
        <source>Assign %n changed lesson(s) to new attempts</source>
        <translation>
            <numerusform>新しい試行に変更後の課題%n件を割り当てる</numerusform>
        </translation>
    </message>
    <message>
        <source>Attempts that have been begun, and scores so far, stay with the version they were made with.</source>
        <translation>開始済みの試行とこれまでの得点は、そのときの版のままです。</translation>
    </message>
    <message>
        <source>%1 (a later version is available)</source>
        <translation>%1（新しい版があります）</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <translation>%1、版%2</translation>
    </message>
    <message>
        <source>given</source>
        <translation>割り当て済み</translation>
    </message>
    <message>
        <source>given, due %1</source>
        <translation>割り当て済み、期限：%1</translation>
    </message>
    <message>
        <source>%1, over</source>
        <translation>%1、期限切れ</translation>
    </message>
    <message>
        <source>There is no day when it is due</source>
        <translation>期限はありません</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>無制限</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>%1 of %2 students</extracomment>
        <translation>%1／%2</translation>
    </message>
    <message>
        <source>%1 of %2 have passed, %3 have tried</source>
        <translation>%2人中%1人が合格、%3人が試行</translation>
    </message>
    <message>
        <source>That was undone.</source>
        <translation>元に戻しました。</translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) assigned.</source>
        <translation>
            <numerusform>課題を%n件割り当てました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) taken back; attempts stay.</source>
        <translation>
            <numerusform>課題を%n件取り下げました。試行は残ります。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lesson(s) changed.</source>
        <translation>
            <numerusform>課題を%n件変更しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>割り当てる</translation>
    </message>
    <message numerus="yes">
        <source>Assign %n lesson(s)</source>
        <translation>
            <numerusform>課題を%n件割り当てる</numerusform>
        </translation>
    </message>
    <message>
        <source>Assign lessons</source>
        <translation>課題を割り当てる</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>Search: a word, or the number of a tooth</source>
        <translation>検索：言葉または歯の番号</translation>
    </message>
    <message>
        <source>Search the lessons</source>
        <translation>課題を検索</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>検索を消去</translation>
    </message>
    <message>
        <source>Lessons to assign</source>
        <translation>割り当てる課題</translation>
    </message>
    <message>
        <source>What %1 is to do</source>
        <extracomment>%1: name of a class</extracomment>
        <translation>%1の課題</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>Due</source>
        <translation>期限</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>試行</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>Nothing is assigned yet. Tick lessons on the left, say when they are due, and assign them; here you will see how many have passed.</source>
        <translation>まだ何も割り当てられていません。左で課題に印を付け、期限を決めて割り当ててください。合格した人数がここに表示されます。</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変更</translation>
    </message>
    <message>
        <source>Change due date and attempts of the chosen lessons</source>
        <translation>選んだ課題の期限と試行回数を変更します</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>取り下げる</translation>
    </message>
    <message>
        <source>Take the chosen lessons back</source>
        <translation>選んだ課題を取り下げます</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message numerus="yes">
        <source>%n student(s) who have not passed have no attempts left: earlier ones count.</source>
        <translation>
            <numerusform>未合格の学生%n人には試行が残っていません。以前の試行も数えられます。</numerusform>
        </translation>
    </message>
    <message>
        <source>No lesson fits. Search for another word.</source>
        <translation>該当する課題がありません。別の言葉で検索してください。</translation>
    </message>
</context>
<context>
    <name>ui::people::AssignTerms</name>
    <message>
        <source>Due on</source>
        <extracomment>A date follows</extracomment>
        <translation>期限</translation>
    </message>
    <message>
        <source>There is a day when it is due</source>
        <translation>期限を設けます</translation>
    </message>
    <message>
        <source>Day when it is due</source>
        <translation>期限の日</translation>
    </message>
    <message>
        <source>Until the end of this day</source>
        <translation>その日の終わりまで</translation>
    </message>
    <message>
        <source>Attempts</source>
        <extracomment>How often a lesson may be tried; a number follows</extracomment>
        <translation>試行</translation>
    </message>
    <message>
        <source>Attempts at most</source>
        <translation>試行回数の上限</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>無制限</translation>
    </message>
    <message>
        <source>The month before</source>
        <translation>前の月</translation>
    </message>
    <message>
        <source>The next month</source>
        <translation>次の月</translation>
    </message>
    <message>
        <source>This day is over: whoever has not passed is late at once.</source>
        <translation>この日はすでに過ぎています。未合格の人はすぐに期限切れになります。</translation>
    </message>
    <message>
        <source>Each lesson keeps what you do not change here.</source>
        <translation>ここで変更しない項目は、各課題でそのまま残ります。</translation>
    </message>
</context>
<context>
    <name>ui::people::ClassCharts</name>
    <message>
        <source>Shown when %1 people have tried the lesson, so that nobody can be made out.</source>
        <translation>個人が特定されないよう、%1人がこの課題を試みてから表示されます。</translation>
    </message>
    <message>
        <source>Best score</source>
        <translation>最高点</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>合格点</translation>
    </message>
    <message>
        <source>Students</source>
        <translation>学生</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>分布</translation>
    </message>
    <message numerus="yes">
        <source>Best scores of %n student(s)</source>
        <translation>
            <numerusform>学生%n人の最高点</numerusform>
        </translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>試行</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Learning curve</source>
        <translation>学習曲線</translation>
    </message>
    <message>
        <source>Of those who made so many attempts</source>
        <translation>その回数の試行をした人について</translation>
    </message>
    <message>
        <source>Lost, % of what it counts</source>
        <translation>失点、配点に対する%</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>評価項目</translation>
    </message>
    <message>
        <source>%1: the class loses %2 % of its points</source>
        <translation>%1：クラスは配点の%2 %を失点</translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation>難しさ</translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2 points: %n student(s)</source>
        <translation>
            <numerusform>%1～%2点：学生%n人</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 passed; first attempts: %3 points</source>
        <translation>%2人中%1人合格。最初の試行：%3点</translation>
    </message>
    <message>
        <source>%1 of %2 passed, after %3 attempts on the average; first attempts: %4 points</source>
        <translation>%2人中%1人合格、平均%3回の試行で。最初の試行：%4点</translation>
    </message>
</context>
<context>
    <name>ui::people::ClassModel</name>
    <message numerus="yes">
        <source>%1, of which %n do not match their recordings and do not count</source>
        <translation>
            <numerusform>%1、うち%n件は記録と一致せず数えられません</numerusform>
        </translation>
    </message>
    <message>
        <source>stuck</source>
        <extracomment>Of a student</extracomment>
        <translation>停滞</translation>
    </message>
    <message>
        <source>no login</source>
        <translation>未ログイン</translation>
    </message>
    <message>
        <source>new</source>
        <extracomment>Of a student who has no attempt yet</extracomment>
        <translation>新規</translation>
    </message>
    <message>
        <source>%1: no attempt yet</source>
        <translation>%1：試行なし</translation>
    </message>
    <message>
        <source>%1: last attempt %2</source>
        <translation>%1：最後の試行 %2</translation>
    </message>
    <message>
        <source>%1: not tried</source>
        <translation>%1：未実施</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>試行%n回</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: best %2, passed, %3, last %4</source>
        <extracomment>%1: student and lesson; %2: points; %3: &quot;4 attempts&quot;; %4: a date</extracomment>
        <translation>%1：最高%2点、合格、%3、最後 %4</translation>
    </message>
    <message>
        <source>%1: best %2, not passed, %3, last %4</source>
        <translation>%1：最高%2点、不合格、%3、最後 %4</translation>
    </message>
    <message>
        <source>Last</source>
        <extracomment>Column: when the student&apos;s last attempt was</extracomment>
        <translation>最後</translation>
    </message>
    <message>
        <source>%1, %2: never logged in</source>
        <translation>%1、%2：未ログイン</translation>
    </message>
    <message>
        <source>%1, %2: last login %3</source>
        <translation>%1、%2：最後のログイン %3</translation>
    </message>
    <message>
        <source>user name</source>
        <translation>ユーザー名</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>needs</source>
        <translation>要対応</translation>
    </message>
    <message>
        <source>last login, UTC</source>
        <translation>最後のログイン、UTC</translation>
    </message>
    <message>
        <source>last attempt, UTC</source>
        <translation>最後の試行、UTC</translation>
    </message>
    <message>
        <source>%1: best score</source>
        <translation>%1：最高点</translation>
    </message>
    <message>
        <source>%1: attempts</source>
        <translation>%1：試行</translation>
    </message>
    <message>
        <source>%1: passed</source>
        <translation>%1：合格</translation>
    </message>
    <message>
        <source>late</source>
        <extracomment>Of a student who has not passed a lesson that is overdue</extracomment>
        <translation>期限超過</translation>
    </message>
    <message>
        <source>%1: not tried, and overdue</source>
        <translation>%1：未実施、期限超過</translation>
    </message>
    <message>
        <source>%1: best %2, not passed and overdue, %3, last %4</source>
        <translation>%1：最高%2点、不合格で期限超過、%3、最後 %4</translation>
    </message>
    <message>
        <source>due %1</source>
        <extracomment>%1: a date</extracomment>
        <translation>期限：%1</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) at most</source>
        <translation>
            <numerusform>試行は%n回まで</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 passed</source>
        <translation>%2人中%1人合格</translation>
    </message>
    <message>
        <source>out of tries</source>
        <extracomment>Of a student who has no attempts left at a lesson that they have not passed</extracomment>
        <translation>回数切れ</translation>
    </message>
    <message>
        <source>%1: best %2, not passed and no attempts left, %3, last %4</source>
        <translation>%1：最高%2点、不合格で残り回数なし、%3、最後 %4</translation>
    </message>
    <message>
        <source>%1: begun, without a score so far, and no attempts left</source>
        <translation>%1：開始済み、まだ点数なし、試行回数の残りなし</translation>
    </message>
    <message>
        <source>%1: begun, without a score so far, and overdue</source>
        <translation>%1：開始済み、まだ点数なし、期限超過</translation>
    </message>
    <message>
        <source>%1: begun, without a score so far</source>
        <translation>%1：開始済み、まだ点数なし</translation>
    </message>
    <message>
        <source>disabled</source>
        <extracomment>Of a student whose account is closed</extracomment>
        <translation>無効</translation>
    </message>
</context>
<context>
    <name>ui::people::ClassPage</name>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1: name of a class; %2: how many students</extracomment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1: how many; %2: &quot;stuck&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Show who made three attempts in a row at a lesson without passing, and without getting better by five points</source>
        <translation>同じ課題で3回続けて合格せず、5点以上の改善もない人を表示します</translation>
    </message>
    <message>
        <source>Show who has never logged in</source>
        <translation>一度もログインしていない人を表示します</translation>
    </message>
    <message>
        <source>Show who has logged in and has no graded attempt yet</source>
        <translation>ログインしたが採点された試行がまだない人を表示します</translation>
    </message>
    <message>
        <source>Nobody needs you just now</source>
        <translation>今、対応が必要な人はいません</translation>
    </message>
    <message numerus="yes">
        <source>%n need(s) you:</source>
        <translation>
            <numerusform>要対応%n人：</numerusform>
        </translation>
    </message>
    <message>
        <source>Here you will see your classes: who needs you, and how everybody does at every lesson. An administrator gives you a class.</source>
        <translation>ここにあなたのクラスが表示されます：対応が必要な人と、全員の各課題の成績です。クラスは管理者が割り当てます。</translation>
    </message>
    <message>
        <source>Nobody is in this class yet. Students are entered by an administrator, one by one or from a list.</source>
        <translation>このクラスにはまだ誰もいません。学生は管理者が1人ずつ、または名簿から登録します。</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>保存しました：%1</translation>
    </message>
    <message>
        <source>%1 could not be written (%2). Try another folder.</source>
        <translation>%1に書き込めませんでした（%2）。別のフォルダーをお試しください。</translation>
    </message>
    <message>
        <source>Save the matrix</source>
        <translation>一覧表を保存</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>クラス</translation>
    </message>
    <message>
        <source>How the class does at</source>
        <translation>クラスの成績：</translation>
    </message>
    <message>
        <source>Lesson whose charts are shown</source>
        <translation>グラフを表示する課題</translation>
    </message>
    <message>
        <source>Best scores, students by lessons</source>
        <translation>最高点、学生と課題</translation>
    </message>
    <message>
        <source>Assign lessons</source>
        <translation>課題を割り当てる</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>報告書</translation>
    </message>
    <message>
        <source>Save as PDF …</source>
        <translation>PDFとして保存 …</translation>
    </message>
    <message>
        <source>Print …</source>
        <translation>印刷 …</translation>
    </message>
    <message>
        <source>Save the matrix as a table (CSV) …</source>
        <translation>一覧表を表（CSV）として保存 …</translation>
    </message>
    <message>
        <source>Show who has not passed a lesson that is overdue</source>
        <translation>期限を過ぎた課題に合格していない人を表示します</translation>
    </message>
    <message>
        <source>%1 (%2 of %3 passed)</source>
        <extracomment>%1: a lesson; %2 of the %3 who tried it</extracomment>
        <translation>%1（%3人中%2人合格）</translation>
    </message>
    <message>
        <source>There is no class yet. Make one, and enter its teachers and students: then you see here who needs help, and how everybody does at every lesson.</source>
        <translation>まだクラスがありません。クラスを作り、教員と学生を登録すると、誰に助けが必要か、各課題の出来がここに表示されます。</translation>
    </message>
    <message>
        <source>Nobody is in this class yet. Enter its students, one by one or from a list.</source>
        <translation>このクラスにはまだ誰もいません。学生を1人ずつ、または名簿から登録してください。</translation>
    </message>
    <message>
        <source>People and classes</source>
        <extracomment>Where people are entered and classes are made</extracomment>
        <translation>人とクラス</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1: a class; %2: a lesson</extracomment>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Show who has no attempts left at a lesson that is not passed. More can be allowed under Assign lessons.</source>
        <translation>合格していない課題の試行回数が残っていない学生を表示します。「課題を割り当てる」で回数を増やせます。</translation>
    </message>
    <message>
        <source>Best score of each student; a tick: passed; ▲: overdue, or no attempts left; ⚠: does not match its recording. A heading sorts, once more the other way, then by name. A cell opens the attempts.</source>
        <translation>各学生の最高点。チェック印：合格、▲：期限超過または残り回数なし、⚠：記録と一致しない。見出しで並べ替え、もう一度で逆順、次に名前順。セルで試行を開きます。</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>検索を消去</translation>
    </message>
    <message numerus="yes">
        <source>%Ln student(s)</source>
        <translation>
            <numerusform>学生%Ln人</numerusform>
        </translation>
    </message>
    <message>
        <source>Search: a student</source>
        <translation>検索：学生</translation>
    </message>
    <message>
        <source>%1 F5 reads the class again; Cusp tries it every ten seconds, too.</source>
        <extracomment>%1: that a class could not be read, and why</extracomment>
        <translation>%1 F5でクラスを読み直します。Cuspも10秒ごとに試みます。</translation>
    </message>
    <message>
        <source>The class is being read …</source>
        <translation>クラスを読み込んでいます …</translation>
    </message>
    <message>
        <source>%1 F5 reads the classes again; Cusp tries it every ten seconds, too.</source>
        <translation>%1 F5でクラスの一覧を読み直します。Cuspも10秒ごとに試みます。</translation>
    </message>
    <message>
        <source>The classes are being read …</source>
        <translation>クラスの一覧を読み込んでいます …</translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryCharts</name>
    <message>
        <source>Attempt %1, %2</source>
        <extracomment>%1: a count; %2: date and time</extracomment>
        <translation>試行%1、%2</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>試行</translation>
    </message>
    <message>
        <source>The newest %1 of %2 attempts</source>
        <translation>%2回の試行のうち最新の%1回</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>試行%n回</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 points, passed</source>
        <translation>%1点、合格</translation>
    </message>
    <message>
        <source>%1 points, not passed</source>
        <translation>%1点、不合格</translation>
    </message>
    <message>
        <source>(machine: %1)</source>
        <translation>（機械採点：%1）</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: which attempt; %2: what it came to</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Middle half</source>
        <translation>中央の半数</translation>
    </message>
    <message>
        <source>Class median</source>
        <translation>クラスの中央値</translation>
    </message>
    <message>
        <source>Attempt %1: median %3, middle half %4 to %5, %2 people</source>
        <extracomment>Of a class; %1: a count of attempts, %2: of people, %3 to %5: points</extracomment>
        <translation>試行%1：中央値%3、中央の半数%4～%5、%2人</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>得点</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>合格点</translation>
    </message>
    <message>
        <source>After the first graded attempt its score is here, and then how it goes on.</source>
        <translation>最初の採点が済むと、ここに得点とその推移が表示されます。</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>評価項目</translation>
    </message>
    <message>
        <source>What costs points</source>
        <translation>失点の内訳</translation>
    </message>
    <message numerus="yes">
        <source>Average of the last %n attempt(s)</source>
        <translation>
            <numerusform>直近%n回の試行の平均</numerusform>
        </translation>
    </message>
    <message>
        <source>After the first graded attempt you see here which criterion costs most.</source>
        <translation>最初の採点が済むと、最も失点の多い評価項目がここに表示されます。</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>分</translation>
    </message>
    <message>
        <source>%1 min</source>
        <extracomment>%1: &quot;12:07&quot;</extracomment>
        <translation>%1分</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>After the first graded attempt you see here how long it took.</source>
        <translation>最初の採点が済むと、かかった時間がここに表示されます。</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>mean %1 N, highest %2 N while cutting</source>
        <translation>切削中の平均%1 N、最大%2 N</translation>
    </message>
    <message>
        <source>Newtons</source>
        <translation>ニュートン</translation>
    </message>
    <message>
        <source>Force while cutting</source>
        <translation>切削中の力</translation>
    </message>
    <message>
        <source>After the first graded attempt you see here how hard the bur was pressed.</source>
        <translation>最初の採点が済むと、バーを押した強さがここに表示されます。</translation>
    </message>
    <message>
        <source>%1 in %2 min</source>
        <translation>%1点、%2分</translation>
    </message>
    <message>
        <source>Class median, time</source>
        <translation>クラスの中央値、時間</translation>
    </message>
    <message>
        <source>Class median, points</source>
        <translation>クラスの中央値、点数</translation>
    </message>
    <message>
        <source>Speed and accuracy</source>
        <translation>速さと正確さ</translation>
    </message>
    <message>
        <source>Good and quick is at the top left</source>
        <translation>左上ほど速くて正確です</translation>
    </message>
    <message>
        <source>After the first graded attempt you see here time against points.</source>
        <translation>最初の採点が済むと、時間と点数の関係がここに表示されます。</translation>
    </message>
    <message numerus="yes">
        <source>Of the last %n attempt(s), each in those where it counts</source>
        <translation>
            <numerusform>直近%n回の試行のうち、それぞれが数えられるもの</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 points lost</source>
        <extracomment>%1: a criterion; %2: a number</extracomment>
        <translation>%1：%2点の減点</translation>
    </message>
    <message>
        <source>Points lost</source>
        <translation>減点</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>レッスン</translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryModel</name>
    <message>
        <source>practice</source>
        <translation>練習</translation>
    </message>
    <message>
        <source>in doubt</source>
        <translation>要確認</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>Given by an instructor. The machine&apos;s score: %1</source>
        <translation>教員による採点です。機械採点：%1</translation>
    </message>
    <message>
        <source>Mean and highest force while cutting</source>
        <translation>切削中の平均と最大の力</translation>
    </message>
    <message>
        <source>%1, given by an instructor; the machine&apos;s score: %2</source>
        <translation>%1、教員による採点。機械採点：%2</translation>
    </message>
    <message>
        <source>Date</source>
        <extracomment>Column of a table of attempts</extracomment>
        <translation>日付</translation>
    </message>
    <message>
        <source>Lesson</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>得点</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Force, N</source>
        <extracomment>Newtons</extracomment>
        <translation>力、N</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新着</translation>
    </message>
    <message>
        <source>read</source>
        <extracomment>Of a teacher&apos;s feedback: to be read yet; not read by the student; read already</extracomment>
        <translation>既読</translation>
    </message>
    <message>
        <source>A teacher has written about this attempt or given another score: open its grade to read it</source>
        <translation>この試行に教員がコメントしたか、別の点数を付けました。採点を開くと読めます</translation>
    </message>
    <message>
        <source>Feedback</source>
        <extracomment>Column of a table of attempts: what a teacher has said</extracomment>
        <translation>講評</translation>
    </message>
    <message>
        <source>unread</source>
        <translation>未読</translation>
    </message>
</context>
<context>
    <name>ui::people::HistoryPage</name>
    <message>
        <source>Criteria</source>
        <translation>評価項目</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>すべての課題</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1: a lesson; %2: how many attempts</extracomment>
        <translation>%1（%2）</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s)</source>
        <translation>
            <numerusform>試行%n回</numerusform>
        </translation>
    </message>
    <message>
        <source>Of this attempt no recording was kept.</source>
        <translation>この試行の記録は保存されていません。</translation>
    </message>
    <message>
        <source>See again how it was done</source>
        <translation>どのように行ったかをもう一度見ます</translation>
    </message>
    <message>
        <source>Attempts of %1</source>
        <translation>%1さんの試行</translation>
    </message>
    <message>
        <source>Show the attempts at this lesson</source>
        <translation>この課題の試行を表示します</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>試行</translation>
    </message>
    <message>
        <source>Open grade</source>
        <translation>成績を開く</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>No attempts yet</source>
        <translation>試行はまだありません</translation>
    </message>
    <message>
        <source>%1 has no attempts yet</source>
        <translation>%1さんの試行はまだありません</translation>
    </message>
    <message>
        <source>Here you will find every attempt that was graded: its score, what cost points, time and force, and how it goes from attempt to attempt. Do a lesson and have it graded.</source>
        <translation>採点されたすべての試行がここに表示されます：得点、失点の理由、時間と力、試行ごとの推移。課題を行い、採点を受けてください。</translation>
    </message>
    <message>
        <source>As soon as an attempt has been graded it is here.</source>
        <translation>採点が済むとすぐにここに表示されます。</translation>
    </message>
    <message>
        <source>Speed</source>
        <extracomment>A chart of speed and accuracy</extracomment>
        <translation>速さ</translation>
    </message>
    <message>
        <source>%1, begun %2</source>
        <extracomment>%1: an exam; %2: when it was begun</extracomment>
        <translation>%1（%2開始）</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>ほか%n件</numerusform>
        </translation>
    </message>
    <message>
        <source>Exams that have no score: %1</source>
        <translation>採点のない試験：%1</translation>
    </message>
    <message>
        <source>See what cost points, and where</source>
        <translation>何がどこで減点になったかを見る</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>自分の試行</translation>
    </message>
    <message>
        <source>See what cost points</source>
        <translation>何が減点になったかを見る</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) wait on this computer, and stand here when the school has them.</source>
        <translation>
            <numerusform>%n 件の試行がこのコンピューターで待機しています。学校に届くとここに表示されます。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::kit::ListTable</name>
    <message>
        <source>Corner of the table</source>
        <translation>表の角</translation>
    </message>
    <message>
        <source>Sorted by: %1, from the least</source>
        <extracomment>%1: a heading</extracomment>
        <translation>並べ替え：%1（小さい順）</translation>
    </message>
    <message>
        <source>Sorted by: %1, from the most</source>
        <translation>並べ替え：%1（大きい順）</translation>
    </message>
</context>
<context>
    <name>ui::people::LoginPage</name>
    <message>
        <source>Language: %1</source>
        <translation>言語：%1</translation>
    </message>
    <message>
        <source>Choose the language</source>
        <translation>表示する言語を選びます</translation>
    </message>
    <message>
        <source>Cusp</source>
        <translation>Cusp</translation>
    </message>
    <message>
        <source>Log in to save your attempts.</source>
        <translation>ログインすると試行が保存されます。</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>ログイン</translation>
    </message>
    <message>
        <source>Choose a password</source>
        <translation>パスワードの設定</translation>
    </message>
    <message>
        <source>The one-time code is correct. Choose your own password: at least eight characters.</source>
        <translation>ワンタイムコードを確認しました。ご自身のパスワードを8文字以上で設定してください。</translation>
    </message>
    <message>
        <source>Set the password</source>
        <translation>パスワードを設定</translation>
    </message>
    <message>
        <source>Welcome to Cusp</source>
        <translation>Cuspへようこそ</translation>
    </message>
    <message>
        <source>Create the school</source>
        <translation>学校を作成</translation>
    </message>
    <message>
        <source>Locked by %1</source>
        <extracomment>%1: the name a user logs in with</extracomment>
        <translation>%1さんがロック中</translation>
    </message>
    <message>
        <source>The work in progress is unchanged.</source>
        <translation>作業中の内容はそのままです。</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>ロック解除</translation>
    </message>
    <message>
        <source>Switch user</source>
        <translation>ユーザーを切り替え</translation>
    </message>
    <message>
        <source>Practise without login</source>
        <translation>ログインせずに練習</translation>
    </message>
    <message>
        <source>Username</source>
        <translation>ユーザー名</translation>
    </message>
    <message>
        <source>Given name</source>
        <translation>名</translation>
    </message>
    <message>
        <source>Family name</source>
        <translation>姓</translation>
    </message>
    <message>
        <source>Password or one-time code</source>
        <translation>パスワードまたはワンタイムコード</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>パスワード</translation>
    </message>
    <message>
        <source>Confirm password</source>
        <translation>パスワード（確認）</translation>
    </message>
    <message>
        <source>Drill and get a grade; nothing is saved</source>
        <translation>切削して採点を受けられます。何も保存されません</translation>
    </message>
    <message>
        <source>The passwords do not match. Type the second one again.</source>
        <translation>2つのパスワードが一致しません。確認用をもう一度入力してください。</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>もう一度</translation>
    </message>
    <message>
        <source>Restore backup (%1)</source>
        <extracomment>%1: day and time</extracomment>
        <translation>バックアップを復元 (%1)</translation>
    </message>
    <message>
        <source>Attempts on this computer that are in no backup are added again. Changes that teachers and admins made after the backup are lost. The current file is kept next to the restored one.</source>
        <translation>このコンピューターの試行のうち、どのバックアップにもないものは再び追加されます。バックアップの後に教員や管理者が行った変更は失われます。現在のファイルは、復元したファイルの隣に残ります。</translation>
    </message>
    <message>
        <source>Change your password</source>
        <translation>パスワードの変更</translation>
    </message>
    <message>
        <source>At least eight characters.</source>
        <translation>8文字以上。</translation>
    </message>
    <message>
        <source>Change the password</source>
        <translation>パスワードを変更する</translation>
    </message>
    <message>
        <source>Cancel</source>
        <extracomment>Back, without having changed the password</extracomment>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Change my password</source>
        <translation>パスワードを変更</translation>
    </message>
    <message>
        <source>Current password</source>
        <translation>現在のパスワード</translation>
    </message>
    <message>
        <source>New password</source>
        <translation>新しいパスワード</translation>
    </message>
    <message>
        <source>Confirm new password</source>
        <translation>新しいパスワード（確認）</translation>
    </message>
    <message>
        <source>This name contains invisible characters. Type it again.</source>
        <translation>この名前には見えない文字が含まれています。もう一度入力してください。</translation>
    </message>
    <message>
        <source>The school&apos;s database was not found: %1 has no users. Restore the backup below, or create a new school and become its admin.</source>
        <translation>学校のデータベースが見つかりません：%1 にはユーザーがいません。下のボタンでバックアップを復元するか、新しい学校を作成してください。作成した場合は、あなたが管理者になります。</translation>
    </message>
    <message>
        <source>Save the attempt just graded as mine</source>
        <translation>いま採点した試行は自分のものとして保存する</translation>
    </message>
    <message>
        <source>%1: saved for the user who logs in. If the box is not checked, the attempt is not saved.</source>
        <extracomment>%1: a lesson or a tooth</extracomment>
        <translation>%1：ログインした人の試行になります。チェックを外すと保存されません。</translation>
    </message>
    <message>
        <source>The work in progress is unchanged, but the exam time keeps running.</source>
        <translation>作業中の内容はそのままですが、試験の時間は進んでいます。</translation>
    </message>
    <message>
        <source>Waiting for the school&apos;s database …</source>
        <translation>学校のデータベースを待っています…</translation>
    </message>
    <message>
        <source>Opening the school&apos;s database …</source>
        <translation>学校のデータベースを開いています…</translation>
    </message>
    <message>
        <source>A username has 1 to 64 characters: the letters a to z, digits and . _ - @.</source>
        <translation>ユーザー名は1〜64文字で、英字a〜z、数字、. _ - @ が使えます。</translation>
    </message>
    <message>
        <source>Set up a school</source>
        <translation>学校を設定</translation>
    </message>
    <message>
        <source>Drill a virtual tooth and see what to do better.</source>
        <translation>仮想の歯を削り、改善点を確かめましょう。</translation>
    </message>
    <message>
        <source>No users yet. You become the admin, and add teachers and students next.</source>
        <translation>まだユーザーがいません。あなたが管理者になり、続いて教員と学生を追加します。</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
</context>
<context>
    <name>ui::scoring::CommentsPanel</name>
    <message>
        <source>%1 points, passed</source>
        <translation>%1点、合格</translation>
    </message>
    <message>
        <source>%1 points, not passed</source>
        <translation>%1点、不合格</translation>
    </message>
    <message>
        <source>Given by %1. The machine&apos;s score: %2 points.</source>
        <translation>%1による採点。機械採点：%2点。</translation>
    </message>
    <message>
        <source>The machine&apos;s score</source>
        <translation>機械採点</translation>
    </message>
    <message>
        <source>at %1 of the replay</source>
        <translation>再生の%1</translation>
    </message>
    <message>
        <source>Pin the comment to this moment</source>
        <translation>コメントをこの時点に付けます</translation>
    </message>
    <message>
        <source>at the marked place</source>
        <translation>印の場所</translation>
    </message>
    <message>
        <source>Pin the comment to this place</source>
        <translation>コメントをこの場所に付けます</translation>
    </message>
    <message>
        <source>▶ %1</source>
        <extracomment>%1: minutes and seconds</extracomment>
        <translation>▶ %1</translation>
    </message>
    <message>
        <source>Show the moment %1</source>
        <translation>時点%1を表示</translation>
    </message>
    <message>
        <source>◎ place</source>
        <translation>◎ 場所</translation>
    </message>
    <message>
        <source>Show the place</source>
        <translation>場所を表示</translation>
    </message>
    <message>
        <source>gave %1 points: %2</source>
        <translation>%1点を付けました：%2</translation>
    </message>
    <message>
        <source>let the machine&apos;s score count again: %1</source>
        <translation>機械採点に戻しました：%1</translation>
    </message>
    <message>
        <source>Write a comment</source>
        <translation>コメントを書く</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>コメント</translation>
    </message>
    <message>
        <source>Add comment</source>
        <translation>コメントを追加</translation>
    </message>
    <message>
        <source>Give another score</source>
        <translation>別の得点を付ける</translation>
    </message>
    <message>
        <source>Points given</source>
        <translation>付ける点数</translation>
    </message>
    <message>
        <source> points</source>
        <extracomment>Behind a number</extracomment>
        <translation> 点</translation>
    </message>
    <message>
        <source>Reason, which the student reads</source>
        <translation>理由（学生が読みます）</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>Give this score</source>
        <translation>この得点を付ける</translation>
    </message>
    <message>
        <source>Back to the machine&apos;s score</source>
        <translation>機械採点に戻す</translation>
    </message>
    <message>
        <source>To pin it, click a place on the tooth above, or play the attempt to a moment and come back.</source>
        <translation>付けるには、上の歯の場所をクリックするか、試行をその時点まで再生して戻ってください。</translation>
    </message>
    <message>
        <source>To pin it to a moment, play the attempt to there and come back.</source>
        <translation>時点に付けるには、試行をそこまで再生して戻ってください。</translation>
    </message>
    <message>
        <source>To pin it to a place, click on the tooth above.</source>
        <translation>場所に付けるには、上の歯をクリックしてください。</translation>
    </message>
    <message numerus="yes">
        <source>Room for %Ln more character(s)</source>
        <translation>
            <numerusform>あと%Ln文字入力できます</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln character(s) too many: a comment has at most %1.</source>
        <translation>
            <numerusform>%Ln文字多すぎます。コメントは%1文字までです。</numerusform>
        </translation>
    </message>
    <message>
        <source>This comment had been taken back already.</source>
        <translation>このコメントはすでに取り下げられていました。</translation>
    </message>
    <message>
        <source>Taken back. Nobody is shown it any more. Its words are here again, to be corrected or cleared.</source>
        <translation>取り下げました。コメントはもう誰にも表示されません。文章はここに戻してあります。直すか、消してください。</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>取り下げる</translation>
    </message>
    <message>
        <source>Take back your comment of %1</source>
        <extracomment>%1: when it was written</extracomment>
        <translation>%1 のコメントを取り下げます</translation>
    </message>
    <message>
        <source>Taken back. Nobody is shown it any more. Its words are here again, below what you are writing.</source>
        <translation>取り消しました。もう誰にも表示されません。その文章は、書きかけの文の下に戻りました。</translation>
    </message>
    <message>
        <source>A score has 0 to 100 points.</source>
        <translation>点数は0から100までです。</translation>
    </message>
    <message>
        <source>Nobody has written anything yet. Where there is a recording, a comment can be pinned to a moment of the replay and to a place on the tooth.</source>
        <translation>まだ何も書かれていません。記録があれば、コメントは再生の時点や歯の場所に付けられます。</translation>
    </message>
    <message>
        <source>Nobody has written anything yet. What an instructor says is here.</source>
        <translation>まだ何も書かれていません。教員のコメントはここに表示されます。</translation>
    </message>
    <message numerus="yes">
        <source>%n comment(s) were typed and are not added yet.</source>
        <translation>
            <numerusform>入力したまま、まだ追加していないコメントが %n 件あります。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n score(s) were typed and are not given yet.</source>
        <translation>
            <numerusform>入力したまま、まだ付けていない点数が %n 件あります。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::people::WelcomeChoices</name>
    <message>
        <source>Practise now</source>
        <translation>今すぐ練習</translation>
    </message>
    <message>
        <source>A tooth with decay is ready. Nothing is saved.</source>
        <translation>う蝕のある歯が用意されています。保存はされません。</translation>
    </message>
    <message>
        <source>Set up a school</source>
        <translation>学校を設定</translation>
    </message>
    <message>
        <source>Users, lessons and score histories. You become the admin.</source>
        <translation>ユーザー、レッスン、得点の履歴。あなたが管理者になります。</translation>
    </message>
</context>
<context>
    <name>ui::text::PeopleTexts</name>
    <message>
        <source>This attempt was made with another version of the lesson than the one that was assigned. It is practice and does not count.</source>
        <translation>この試行は課された版とは別の版で行われました。練習であり、数えられません。</translation>
    </message>
    <message>
        <source>The recording is missing, damaged or not of this attempt. The score does not count until a teacher gives one.</source>
        <translation>記録がないか、破損しているか、この試行のものではありません。教員が得点を付けるまで数えられません。</translation>
    </message>
    <message>
        <source>The recording gives another result than the one that was reported. The score does not count until a teacher gives one.</source>
        <translation>記録からは報告と異なる結果が得られます。教員が得点を付けるまで数えられません。</translation>
    </message>
    <message>
        <source>This exam was not begun as its recording says: its start is missing here, or less time has passed since than was worked. The score does not count until a teacher gives one.</source>
        <translation>この試験は記録どおりに開始されていません。開始の記録がないか、開始からの時間が作業時間より短いためです。教員が得点を付けるまで数えられません。</translation>
    </message>
    <message>
        <source>Free practice</source>
        <translation>自由練習</translation>
    </message>
    <message>
        <source>today</source>
        <translation>今日</translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>昨日</translation>
    </message>
    <message>
        <source>d MMM</source>
        <extracomment>A day without its year, as QLocale::toString() takes it: &quot;27 Nov&quot;. German &quot;d. MMM&quot;, Japanese &quot;M月d日&quot;</extracomment>
        <translation>M月d日</translation>
    </message>
    <message>
        <source>MMM yyyy</source>
        <extracomment>A month, as QLocale::toString() takes it: &quot;Nov 2024&quot;</extracomment>
        <translation>yyyy年M月</translation>
    </message>
</context>
<context>
    <name>ui::presets::FeedChart</name>
    <message>
        <source>Feed over force</source>
        <translation>力に対する送り速度</translation>
    </message>
    <message>
        <source>%1 %2 mm/s</source>
        <extracomment>%1 is a material, %2 a speed</extracomment>
        <translation>%1 %2 mm/s</translation>
    </message>
    <message>
        <source>Straight down with %1 N</source>
        <extracomment>%1 is a force</extracomment>
        <translation>真下へ%1 N</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>力、N</translation>
    </message>
    <message>
        <source>Feed, mm/s</source>
        <translation>送り速度、mm/s</translation>
    </message>
    <message>
        <source>dashed: as it was kept</source>
        <translation>破線：保存されている値</translation>
    </message>
    <message>
        <source>%1, as it was kept</source>
        <extracomment>%1 is a material; its line is that of the preset before it was changed</extracomment>
        <translation>%1（保存時）</translation>
    </message>
</context>
<context>
    <name>ui::presets::PresetTable</name>
    <message>
        <source>Material</source>
        <translation>材質</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>切削率</translation>
    </message>
    <message>
        <source>Cuts from</source>
        <extracomment>The force from which on a material is cut</extracomment>
        <translation>切削開始</translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation>範囲：%1。</translation>
    </message>
</context>
<context>
    <name>ui::presets::PresetsPage</name>
    <message>
        <source>Hardness presets</source>
        <translation>硬さのプリセット</translation>
    </message>
    <message>
        <source>Hardness presets and their versions</source>
        <translation>硬さのプリセットとその版</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>読み込み …</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>プリセットを読み込む</translation>
    </message>
    <message>
        <source>Read a preset from a file and keep it here</source>
        <translation>ファイルからプリセットを読み込み、ここに保存します</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>書き出し …</translation>
    </message>
    <message>
        <source>Export this version</source>
        <translation>この版を書き出す</translation>
    </message>
    <message>
        <source>Write the chosen version to a file, for another school</source>
        <translation>選んだ版を、ほかの学校のためにファイルへ書き出します</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>プリセットの名前</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Notes: what it is for</source>
        <translation>メモ：用途</translation>
    </message>
    <message>
        <source>Simple</source>
        <translation>簡易</translation>
    </message>
    <message>
        <source>A few sliders</source>
        <translation>少数のスライダー</translation>
    </message>
    <message>
        <source>All numbers</source>
        <translation>すべての数値</translation>
    </message>
    <message>
        <source>Every number with its range</source>
        <translation>すべての数値と範囲</translation>
    </message>
    <message>
        <source>Feed of</source>
        <translation>送り速度：</translation>
    </message>
    <message>
        <source>Bur whose feed is drawn</source>
        <translation>送り速度を描くバー</translation>
    </message>
    <message>
        <source>Try on a block</source>
        <translation>ブロックで試す</translation>
    </message>
    <message>
        <source>Drill a block of enamel, dentin and soft caries with it</source>
        <translation>エナメル質、象牙質、軟らかいう蝕のブロックを切削してみます</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Duplicate under another name</source>
        <translation>別の名前で複製</translation>
    </message>
    <message>
        <source>Begin a preset of another name with these numbers</source>
        <translation>この数値で別の名前のプリセットを始めます</translation>
    </message>
    <message>
        <source>Use for practice</source>
        <translation>練習に使う</translation>
    </message>
    <message>
        <source>Use this version for practice</source>
        <translation>この版を練習に使う</translation>
    </message>
    <message>
        <source>Every tooth feels like this, unless its lesson says otherwise</source>
        <translation>課題に指定がない限り、すべての歯がこの手応えになります</translation>
    </message>
    <message>
        <source>Compare blind with</source>
        <translation>ブラインド比較の相手</translation>
    </message>
    <message>
        <source>Preset to compare with</source>
        <translation>比較するプリセット</translation>
    </message>
    <message>
        <source>Number of trials</source>
        <translation>試行の回数</translation>
    </message>
    <message>
        <source>Trials:</source>
        <extracomment>Before a number</extracomment>
        <translation>試行：</translation>
    </message>
    <message>
        <source>Compare A and B</source>
        <translation>AとBを比較</translation>
    </message>
    <message>
        <source>Drill with both, behind letters, and say which feels more like a tooth</source>
        <translation>記号で伏せた両方で切削し、どちらが歯に近いかを答えます</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>第%1版</translation>
    </message>
    <message>
        <source>shipped</source>
        <translation>付属</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>使用中</translation>
    </message>
    <message>
        <source>changed from %1</source>
        <translation>%1から変更</translation>
    </message>
    <message>
        <source>Restore as the newest version</source>
        <translation>最新版として復元</translation>
    </message>
    <message>
        <source>Save as a new version</source>
        <translation>新しい版として保存</translation>
    </message>
    <message>
        <source>A version is never changed: this becomes another</source>
        <translation>版は変更されません。これは別の版になります</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <extracomment>%1 is the name of a preset that is duplicated</extracomment>
        <translation>%1のコピー</translation>
    </message>
    <message>
        <source>An admin keeps the school&apos;s presets</source>
        <translation>学校のプリセットは管理者が保存します</translation>
    </message>
    <message>
        <source>These two feel the same: choose another, or change a number</source>
        <translation>この2つは同じ感触です。別のものを選ぶか、数値を変えてください</translation>
    </message>
    <message>
        <source>What you have changed of the hardness preset %1 is not saved.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation>硬さプリセット「%1」の変更は保存されていません。</translation>
    </message>
    <message>
        <source>retired</source>
        <extracomment>A hardness preset that nobody is offered any more</extracomment>
        <translation>使用終了</translation>
    </message>
    <message>
        <source>Take up again</source>
        <translation>再び使う</translation>
    </message>
    <message>
        <source>Retire</source>
        <translation>使用を終える</translation>
    </message>
    <message>
        <source>Offer this preset again</source>
        <translation>このプリセットを再び使う</translation>
    </message>
    <message>
        <source>Retire this preset</source>
        <translation>このプリセットの使用を終える</translation>
    </message>
    <message>
        <source>What is in use or shipped is not retired</source>
        <translation>使用中または付属のものは外せません</translation>
    </message>
    <message>
        <source>It is offered again, in all its versions</source>
        <translation>すべてのバージョンがまた選べるようになります</translation>
    </message>
    <message>
        <source>Nobody is offered it any more; attempts go on naming it</source>
        <translation>だれにも表示されなくなります。これまでの試行には名前が残ります</translation>
    </message>
</context>
<context>
    <name>ui::presets::SimplePanel</name>
    <message>
        <source>Enamel</source>
        <translation>エナメル質</translation>
    </message>
    <message>
        <source>softer</source>
        <translation>軟らかく</translation>
    </message>
    <message>
        <source>harder</source>
        <translation>硬く</translation>
    </message>
    <message>
        <source>Dentin</source>
        <translation>象牙質</translation>
    </message>
    <message>
        <source>Caries</source>
        <translation>う蝕</translation>
    </message>
    <message>
        <source>Plastic tooth</source>
        <translation>プラスチック歯</translation>
    </message>
    <message>
        <source>Touch that cuts</source>
        <extracomment>How hard one must press before anything comes away</extracomment>
        <translation>切れ始める力</translation>
    </message>
    <message>
        <source>lighter</source>
        <translation>軽く</translation>
    </message>
    <message>
        <source>heavier</source>
        <translation>重く</translation>
    </message>
    <message>
        <source>Wall</source>
        <extracomment>What an uncut tooth feels like under the bur</extracomment>
        <translation>壁</translation>
    </message>
    <message>
        <source>stiffer</source>
        <translation>硬く</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <extracomment>A slider: what it is about, and the words at its ends</extracomment>
        <translation>%1、%2～%3</translation>
    </message>
    <message>
        <source>In the middle: the numbers that were typed.</source>
        <extracomment>Of sliders. %1 is a hardness preset</extracomment>
        <translation>中央：入力された数値。</translation>
    </message>
    <message>
        <source>In the middle: %1.</source>
        <translation>中央：%1。</translation>
    </message>
</context>
<context>
    <name>ui::presets::TrialCard</name>
    <message>
        <source>Feel A</source>
        <translation>Aの手応え</translation>
    </message>
    <message>
        <source>Feel B</source>
        <translation>Bの手応え</translation>
    </message>
    <message>
        <source>Drill with the preset behind A from now on</source>
        <translation>ここからAのプリセットで切削します</translation>
    </message>
    <message>
        <source>Drill with the preset behind B from now on</source>
        <translation>ここからBのプリセットで切削します</translation>
    </message>
    <message>
        <source>A does</source>
        <extracomment>Which of two presets feels more like a tooth</extracomment>
        <translation>Aのほう</translation>
    </message>
    <message>
        <source>B does</source>
        <translation>Bのほう</translation>
    </message>
    <message>
        <source>No difference</source>
        <translation>違いなし</translation>
    </message>
    <message>
        <source>All as it was</source>
        <translation>すべて元どおり</translation>
    </message>
    <message>
        <source>Set all sliders back to the preset</source>
        <translation>すべてのスライダーをプリセットに戻します</translation>
    </message>
    <message>
        <source>Save as CSV …</source>
        <translation>CSVとして保存 …</translation>
    </message>
    <message>
        <source>Save the comparison as CSV</source>
        <translation>比較をCSVとして保存</translation>
    </message>
    <message>
        <source>Back to the presets</source>
        <translation>プリセットへ戻る</translation>
    </message>
    <message>
        <source>Drill: each slider is felt at once.</source>
        <translation>切削してください。スライダーはすぐに手応えに表れます。</translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <extracomment>%1 of %2 trials</extracomment>
        <translation>試行%1／%2</translation>
    </message>
    <message>
        <source>Drill with A and with B, as often as you like. Which feels more like a tooth?</source>
        <translation>AとBで好きなだけ切削してください。どちらが歯に近いですか？</translation>
    </message>
    <message>
        <source>Compared</source>
        <translation>比較結果</translation>
    </message>
    <message numerus="yes">
        <source>%1: chosen %n time(s).</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation>
            <numerusform>%1：%n回選択。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No difference: %n time(s).</source>
        <translation>
            <numerusform>違いなし：%n回。</numerusform>
        </translation>
    </message>
    <message>
        <source>That says nothing: they came out as even as can be.</source>
        <translation>これからは何も言えません。まったくの五分五分でした。</translation>
    </message>
    <message numerus="yes">
        <source>That is hardly chance: tossing a coin comes out as uneven only %n time(s) in 100.</source>
        <translation>
            <numerusform>偶然とは考えにくい結果です。硬貨を投げてこれほど偏るのは100回中 %n 回だけです。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>That may be chance: tossing a coin comes out as uneven %n time(s) in 100. Compare more often to be sure.</source>
        <translation>
            <numerusform>偶然かもしれません。硬貨を投げても100回中 %n 回はこれほど偏ります。確かめるには、もっと比べてください。</numerusform>
        </translation>
    </message>
    <message>
        <source>First cut a little with both</source>
        <translation>まず両方で少し削ってください</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>比較を終える</translation>
    </message>
    <message>
        <source>What has been answered counts, and it is told which was which</source>
        <translation>ここまでの回答を集計し、どちらがどのプリセットだったかを示します</translation>
    </message>
    <message>
        <source>It was ended before anything was chosen.</source>
        <translation>何も選ばれないうちに終了しました。</translation>
    </message>
    <message>
        <source>Block of</source>
        <extracomment>What the block is made of on which a hardness preset is tried</extracomment>
        <translation>ブロックの材質</translation>
    </message>
    <message>
        <source>What the block is made of</source>
        <translation>ブロックの材質</translation>
    </message>
    <message>
        <source>enamel, dentin, soft decay</source>
        <translation>エナメル質・象牙質・軟らかいう蝕</translation>
    </message>
    <message>
        <source>enamel, dentin, firm decay</source>
        <translation>エナメル質・象牙質・硬いう蝕</translation>
    </message>
    <message>
        <source>plastic throughout</source>
        <translation>全体がプラスチック</translation>
    </message>
</context>
<context>
    <name>ui::text::PresetTexts</name>
    <message>
        <source>Soft caries</source>
        <translation>軟らかいう蝕</translation>
    </message>
    <message>
        <source>Firm caries</source>
        <translation>硬いう蝕</translation>
    </message>
    <message>
        <source>Enamel</source>
        <translation>エナメル質</translation>
    </message>
    <message>
        <source>Dentin</source>
        <translation>象牙質</translation>
    </message>
    <message>
        <source>Pulp</source>
        <translation>歯髄</translation>
    </message>
    <message>
        <source>Plastic tooth</source>
        <extracomment>What the teeth of a typodont are made of</extracomment>
        <translation>プラスチック歯</translation>
    </message>
    <message>
        <source>%1: rate</source>
        <extracomment>%1 is a material of a tooth</extracomment>
        <translation>%1：切削率</translation>
    </message>
    <message>
        <source>%1: from</source>
        <translation>%1：切削開始</translation>
    </message>
    <message>
        <source>Share along the bur</source>
        <translation>バー軸方向の割合</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>剛性</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>減衰</translation>
    </message>
    <message>
        <source>Damping of fast motion</source>
        <translation>速い動きの減衰</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>摩擦</translation>
    </message>
    <message>
        <source>Force limit</source>
        <translation>力の上限</translation>
    </message>
    <message>
        <source>Volume that a newton beyond the threshold takes away in a second, pushing sideways.</source>
        <translation>横に押したとき、しきい値を超える1 Nが1秒間に除去する体積。</translation>
    </message>
    <message>
        <source>A lighter touch leaves no mark.</source>
        <translation>これより軽く触れても跡は残りません。</translation>
    </message>
    <message>
        <source>What is left of the rate when the bur is pushed along its axis.</source>
        <translation>バーを軸方向に押したときに残る切削率。</translation>
    </message>
    <message>
        <source>Of the spring between hand and bur: how hard a wall feels.</source>
        <translation>手とバーの間のばねの剛性：壁の硬さの感じ方。</translation>
    </message>
    <message>
        <source>What calms the hand at rest. Too much is felt as a buzz.</source>
        <translation>静止した手を落ち着かせます。強すぎると振動に感じます。</translation>
    </message>
    <message>
        <source>What calms a fast hand besides, as when the bur is thrown at the tooth.</source>
        <translation>加えて、バーを歯に投げ当てるような速い動きを抑えます。</translation>
    </message>
    <message>
        <source>Of the bur that slides on the tooth.</source>
        <translation>歯の上を滑るバーの摩擦。</translation>
    </message>
    <message>
        <source>The largest force that is ever given to the hand.</source>
        <translation>手に与えられる最大の力。</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <extracomment>A range: %1 to %2, %3 is a unit</extracomment>
        <translation>%1～%2 %3</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <extracomment>%1 is the name of a hardness preset, %2 its version</extracomment>
        <translation>%1、第%2版</translation>
    </message>
    <message>
        <source>%1, changed by hand</source>
        <extracomment>After the name of a hardness preset whose numbers were changed during the attempt</extracomment>
        <translation>%1、手動で変更</translation>
    </message>
    <message>
        <source>The force limit is %1 N, and the device gives at most %2 N: lower it.</source>
        <translation>力の上限は%1 Nですが、デバイスの最大は%2 Nです。下げてください。</translation>
    </message>
    <message>
        <source>Holds: a light hand at %1 ms of delay is steady up to %2 N/mm, and this is %3.</source>
        <translation>安定：遅れ%1 msの軽い手では%2 N/mmまで安定し、これは%3です。</translation>
    </message>
    <message>
        <source>Would tremble: a light hand at %1 ms of delay is steady up to %2 N/mm, and this is %3.</source>
        <translation>不安定：遅れ%1 msの軽い手では%2 N/mmまで安定しますが、これは%3です。</translation>
    </message>
    <message>
        <source>Lower the stiffness, or damp more.</source>
        <translation>剛性を下げるか、減衰を増やしてください。</translation>
    </message>
    <message>
        <source>Lower the stiffness.</source>
        <translation>剛性を下げてください。</translation>
    </message>
    <message>
        <source>Share of flat ends</source>
        <extracomment>Of a bur whose end is flat, such as a pear or a fissure bur</extracomment>
        <translation>平らな先端の割合</translation>
    </message>
    <message>
        <source>Full load</source>
        <extracomment>The load on the bur beyond which it cuts no faster</extracomment>
        <translation>最大有効荷重</translation>
    </message>
    <message>
        <source>What a pear or a fissure bur has of the share along the bur. At 1 the end makes no difference.</source>
        <translation>ペアー形バーやフィッシャーバーに残る、バー軸方向の割合に対する比率。1 では先端の形による差がありません。</translation>
    </message>
    <message>
        <source>A bur pressed harder cuts no faster. At 20 N there is no such limit.</source>
        <translation>これより強く押しても切削は速くなりません。20 N ではこの限度がありません。</translation>
    </message>
</context>
<context>
    <name>ui::practice::HistoryPanel</name>
    <message>
        <source>Undo history</source>
        <translation>操作履歴</translation>
    </message>
    <message>
        <source>Click a state, or press Enter, to return to it</source>
        <translation>状態をクリックするかEnterを押すと、その状態に戻ります</translation>
    </message>
    <message>
        <source>Each stroke appears here as a small picture. Click a picture to go back to it. Later strokes stay as a separate branch.</source>
        <translation>ストロークごとに、ここに小さな画像が現れます。画像をクリックするとその時点に戻ります。その後のストロークは別の枝として残ります。</translation>
    </message>
</context>
<context>
    <name>ui::replay::ReplayBar</name>
    <message>
        <source>You are watching a recording</source>
        <translation>記録を再生しています</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop the replay</source>
        <translation>再生を停止</translation>
    </message>
    <message>
        <source>Stop the replay and return to your own work (Esc)</source>
        <translation>再生をやめてご自身の作業に戻ります（Esc）</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>Progress of a recording: minutes and seconds played, and of the whole</extracomment>
        <translation>%1／%2</translation>
    </message>
    <message>
        <source>%1×</source>
        <extracomment>Speed of a replay: so many times as fast as it was made</extracomment>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Speed of the replay: %1</source>
        <translation>再生速度：%1</translation>
    </message>
</context>
<context>
    <name>ui::replay::TimeLine</name>
    <message>
        <source>Time line</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>Left and Right move from stroke to stroke, Home and End to the beginning and the end.</source>
        <translation>左右キーでストロークごとに、HomeとEndで最初と最後に移動します。</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>On a time line: a time, and what happened then</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Stroke %1, %2 s, %3</source>
        <translation>ストローク%1、%2秒、%3</translation>
    </message>
    <message>
        <source>Interruption of %1, not counted as working time</source>
        <translation>%1 の中断（作業時間に入りません）</translation>
    </message>
</context>
<context>
    <name>ui::report::ClassReport</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: what they need; %2: names</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Stuck (three attempts in a row, not passed, not better by five points)</source>
        <translation>停滞（3回続けて合格せず、5点以上の改善なし）</translation>
    </message>
    <message>
        <source>Never logged in</source>
        <translation>未ログイン</translation>
    </message>
    <message>
        <source>Logged in, no graded attempt yet</source>
        <translation>ログイン済み、採点された試行なし</translation>
    </message>
    <message numerus="yes">
        <source>%n student(s)</source>
        <translation>
            <numerusform>学生%n人</numerusform>
        </translation>
    </message>
    <message>
        <source>The class at: %1</source>
        <translation>クラスの成績：%1</translation>
    </message>
    <message>
        <source>Late: a lesson is overdue and not passed</source>
        <translation>期限超過：期限を過ぎた課題に不合格</translation>
    </message>
    <message>
        <source>Class: %1</source>
        <translation>クラス：%1</translation>
    </message>
    <message>
        <source>Rubric: %1, version %2, content %3</source>
        <translation>評価基準：%1、第%2版、内容%3</translation>
    </message>
    <message>
        <source>No attempts left at a lesson that is not passed</source>
        <translation>合格していない課題の試行回数が残っていない</translation>
    </message>
    <message>
        <source>Best scores</source>
        <translation>最高点</translation>
    </message>
    <message>
        <source>✓: passed; ▲: overdue, or no attempts left; ⚠: does not match its recording; ▲ behind a name: needs the teacher</source>
        <translation>✓：合格、▲：期限超過または残り回数なし、⚠：記録と一致しない、名前の後の▲：教員の対応が必要</translation>
    </message>
</context>
<context>
    <name>ui::report::ScoreCard</name>
    <message>
        <source>Score card: %1</source>
        <translation>成績表：%1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1: a person; %2: date and time</extracomment>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Given by an instructor. Automatic score: %1 points.</source>
        <translation>教員による採点。自動採点：%1点。</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <extracomment>%1: a person; %2: date and time; %3: why</extracomment>
        <translation>%1、%2：%3</translation>
    </message>
    <message>
        <source>Self-assessment before the score: %1 points</source>
        <translation>得点を見る前の予想：%1点</translation>
    </message>
    <message>
        <source>Time %1 min; cutting force: mean %2 N, maximum %3 N</source>
        <extracomment>&quot;12:07&quot;</extracomment>
        <translation>時間%1分。切削中の力 平均%2 N、最大%3 N</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>ほか%n件</numerusform>
        </translation>
    </message>
    <message>
        <source>not met</source>
        <translation>超過</translation>
    </message>
    <message>
        <source>met</source>
        <translation>遵守</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>Lost of a weight, both points: &quot;−4.4 of 30.0&quot;</extracomment>
        <translation>%1／%2</translation>
    </message>
    <message>
        <source>Lost points</source>
        <translation>失点の内訳</translation>
    </message>
    <message>
        <source>On the tooth, and in a section through the largest deviation</source>
        <translation>歯の上、および最大のずれを通る断面</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>コメント</translation>
    </message>
    <message>
        <source>Details of grading and recording</source>
        <translation>採点と作業の条件</translation>
    </message>
    <message>
        <source>Rubric: %1, version %2, content %3</source>
        <translation>評価基準：%1、第%2版、内容%3</translation>
    </message>
    <message>
        <source>Hardness: %1, content %2</source>
        <translation>硬さ：%1、内容%2</translation>
    </message>
    <message>
        <source>Device: %1; contact: %2; grid: %3 columns a side; view: %4; seed: %5</source>
        <translation>デバイス：%1、接触：%2、格子：一辺%3列、表示：%4、シード：%5</translation>
    </message>
    <message>
        <source>Made with Cusp %1; recording %2; attempt %3</source>
        <translation>Cusp %1で作成、記録%2、試行%3</translation>
    </message>
    <message>
        <source>Not measured: undercuts and walls past 90°, because the model is a height field.</source>
        <translation>測定なし：アンダーカットと90°を超える壁（モデルは高さのデータのため）。</translation>
    </message>
    <message>
        <source>%1, %2, at %3 of the replay</source>
        <translation>%1、%2、再生の%3</translation>
    </message>
    <message>
        <source>%1 of 100 points, pass mark %2. %3</source>
        <extracomment>%1 and %2: points; %3: &quot;Passed&quot;, &quot;Not passed: critical error&quot;</extracomment>
        <translation>100点中%1点、合格点%2。%3</translation>
    </message>
    <message>
        <source>Comments, with the numbers of their places in the picture of the tooth</source>
        <translation>コメント（番号は歯の画像での位置）</translation>
    </message>
    <message>
        <source>mouse, pen or gamepad</source>
        <translation>マウス、ペン、ゲームパッド</translation>
    </message>
    <message>
        <source>simulated handpiece</source>
        <translation>模擬ハンドピース</translation>
    </message>
    <message>
        <source>continuous</source>
        <extracomment>How the point of contact is found: anywhere, not only on a lattice</extracomment>
        <translation>連続</translation>
    </message>
    <message>
        <source>on a lattice</source>
        <extracomment>How the point of contact is found</extracomment>
        <translation>格子上</translation>
    </message>
    <message>
        <source>on a lattice, 16 steps a tick</source>
        <extracomment>How the point of contact is found</extracomment>
        <translation>格子上、1周期に16段階</translation>
    </message>
    <message>
        <source>by depth</source>
        <extracomment>How force is found: the deeper inside, the harder it is pushed out</extracomment>
        <translation>深さによる</translation>
    </message>
    <message>
        <source>flat</source>
        <extracomment>A picture that is no stereo picture</extracomment>
        <translation>平面</translation>
    </message>
    <message>
        <source>red and cyan glasses, in colour</source>
        <translation>赤青めがね、カラー</translation>
    </message>
    <message>
        <source>red and cyan glasses, in grey</source>
        <translation>赤青めがね、グレー</translation>
    </message>
    <message>
        <source>stereo, halves side by side</source>
        <translation>立体視、左右に分割</translation>
    </message>
    <message>
        <source>stereo, halves one above the other</source>
        <translation>立体視、上下に分割</translation>
    </message>
    <message>
        <source>Rubric: content %1</source>
        <translation>評価基準：内容%1</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>マウス</translation>
    </message>
    <message>
        <source>pen</source>
        <translation>ペン</translation>
    </message>
    <message>
        <source>keyboard</source>
        <translation>キーボード</translation>
    </message>
    <message>
        <source>gamepad</source>
        <translation>ゲームパッド</translation>
    </message>
</context>
<context>
    <name>ui::report::Sheet</name>
    <message>
        <source>Cusp %1, printed %2</source>
        <translation>Cusp %1、印刷%2</translation>
    </message>
    <message>
        <source>%1, page %2</source>
        <translation>%1、%2ページ</translation>
    </message>
    <message>
        <source>Audit code: %1</source>
        <translation>監査コード：%1</translation>
    </message>
    <message>
        <source>Not kept in a school&apos;s database: there is no audit code</source>
        <translation>学校のデータベースに保存されていないため、監査コードはありません</translation>
    </message>
    <message>
        <source>%1, page %2 of %3</source>
        <translation>%1、%3ページ中%2ページ</translation>
    </message>
</context>
<context>
    <name>ui::settings::SettingsPage</name>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Search the settings</source>
        <translation>設定を検索</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>検索を消去</translation>
    </message>
    <message>
        <source>From %1.</source>
        <translation>範囲：%1。</translation>
    </message>
    <message>
        <source>Set it back</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Set back: %1</source>
        <extracomment>%1 is the name of a setting</extracomment>
        <translation>元に戻す：%1</translation>
    </message>
    <message>
        <source>No setting is called so, and none speaks of it. Look for one word, such as &quot;force&quot;.</source>
        <translation>その名前の設定も、それについての設定もありません。「力」のように一語で探してください。</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>ウィンドウ</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Of every window, at once.</source>
        <translation>すべてのウィンドウに、すぐに反映されます。</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>ページの色</translation>
    </message>
    <message>
        <source>From the next start on. The practice room is always dark.</source>
        <translation>次回の起動から。練習室は常に暗い色です。</translation>
    </message>
    <message>
        <source>as the desktop</source>
        <translation>デスクトップに合わせる</translation>
    </message>
    <message>
        <source>light</source>
        <translation>明るい</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>暗い</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>手</translation>
    </message>
    <message>
        <source>Mouse or pen, a simulated hand, or a force device: choose, home and try it.</source>
        <translation>マウスまたはペン、シミュレーションの手、力覚デバイス：選び、原点を合わせ、試します。</translation>
    </message>
</context>
<context>
    <name>ui::window::AccountMenu</name>
    <message>
        <source>My account</source>
        <translation>アカウント</translation>
    </message>
    <message>
        <source>Change my password …</source>
        <translation>パスワードを変更 …</translation>
    </message>
</context>
<context>
    <name>ui::kit::Actions</name>
    <message>
        <source>Drill</source>
        <translation>切削</translation>
    </message>
    <message>
        <source>Drill on or off</source>
        <translation>切削のオン・オフ</translation>
    </message>
    <message>
        <source>Start or stop the bur</source>
        <translation>バーを回す、または止めます</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Undo the last stroke</source>
        <translation>直前のストロークを取り消します</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Redo the stroke that was undone</source>
        <translation>取り消したストロークをもう一度行います</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Show or hide the undo history with all its branches</source>
        <translation>操作履歴をすべての枝とともに表示、または隠します</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>最初からやり直す</translation>
    </message>
    <message>
        <source>Reset the tooth; Undo restores your work</source>
        <translation>歯を元の状態に戻します。「元に戻す」で作業を復元できます</translation>
    </message>
    <message>
        <source>Grade</source>
        <translation>採点</translation>
    </message>
    <message>
        <source>Measure your preparation and explain the grade</source>
        <translation>切削を測定し、成績を説明します</translation>
    </message>
    <message>
        <source>Handpiece</source>
        <translation>ハンドピース</translation>
    </message>
    <message>
        <source>Use this bur</source>
        <translation>このバーを使います</translation>
    </message>
    <message>
        <source>Use this handpiece</source>
        <translation>このハンドピースを使います</translation>
    </message>
    <message>
        <source>Other hand</source>
        <translation>反対の手</translation>
    </message>
    <message>
        <source>Hold the handpiece from the other side; the view stays</source>
        <translation>ハンドピースを反対側から持ちます。視点は変わりません</translation>
    </message>
    <message>
        <source>Return the handpiece</source>
        <translation>ハンドピースを定位置へ</translation>
    </message>
    <message>
        <source>Let the handpiece guide your hand back over the tooth</source>
        <translation>ハンドピースが手を歯の上へ導きます</translation>
    </message>
    <message>
        <source>Tooth and files</source>
        <translation>歯とファイル</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>Choose what to practise</source>
        <translation>練習する内容を選びます</translation>
    </message>
    <message>
        <source>Edit the lesson …</source>
        <translation>課題を編集 …</translation>
    </message>
    <message>
        <source>Change the ideal and the rubric of the selected lesson</source>
        <translation>選んだ課題の理想形と評価基準を変更します</translation>
    </message>
    <message>
        <source>Hardness presets</source>
        <translation>硬さのプリセット</translation>
    </message>
    <message>
        <source>Choose, try and change how drilling feels</source>
        <translation>切削の手応えを選び、試し、変更します</translation>
    </message>
    <message>
        <source>Choose a tooth</source>
        <translation>歯を選ぶ</translation>
    </message>
    <message>
        <source>Show the arches and choose one of 16 teeth</source>
        <translation>歯列を表示し、16歯から1つを選びます</translation>
    </message>
    <message>
        <source>Whole mouth</source>
        <translation>口腔全体</translation>
    </message>
    <message>
        <source>Choose a tooth in the whole mouth, or go back to the flat arches</source>
        <translation>口腔全体から歯を選ぶ、または平面の歯列に戻ります</translation>
    </message>
    <message>
        <source>Open a scan</source>
        <translation>スキャンを開く</translation>
    </message>
    <message>
        <source>Open the scan of a tooth: OBJ, STL or PLY</source>
        <translation>歯のスキャンを開きます：OBJ、STL、PLY</translation>
    </message>
    <message>
        <source>Save the recording</source>
        <translation>記録を保存</translation>
    </message>
    <message>
        <source>Save every movement of this attempt to a file</source>
        <translation>この試行のすべての動きをファイルに保存します</translation>
    </message>
    <message>
        <source>Save this attempt as a reference …</source>
        <translation>この試行を基準として保存 …</translation>
    </message>
    <message>
        <source>Save your preparation as an ideal for lessons</source>
        <translation>切削した形を、課題の理想形として保存します</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>記録を開く</translation>
    </message>
    <message>
        <source>Replay a saved attempt</source>
        <translation>保存した試行を再生します</translation>
    </message>
    <message>
        <source>The expert&apos;s attempt</source>
        <translation>エキスパートの試行</translation>
    </message>
    <message>
        <source>Watch how an expert does it; during a replay, beside this attempt</source>
        <translation>エキスパートの手順を見ます。再生中はこの試行の隣に表示します</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Resume the replay</source>
        <translation>再生を再開</translation>
    </message>
    <message>
        <source>Pause the replay</source>
        <translation>再生を一時停止</translation>
    </message>
    <message>
        <source>Pause or resume the replay</source>
        <translation>再生を一時停止、または再開します</translation>
    </message>
    <message>
        <source>Previous stroke</source>
        <translation>前のストローク</translation>
    </message>
    <message>
        <source>Go to the end of the previous stroke and pause</source>
        <translation>前のストロークの終わりに戻って止まります</translation>
    </message>
    <message>
        <source>Next stroke</source>
        <translation>次のストローク</translation>
    </message>
    <message>
        <source>Go to the end of the next stroke and pause</source>
        <translation>次のストロークの終わりまで進んで止まります</translation>
    </message>
    <message>
        <source>To the beginning</source>
        <translation>最初へ</translation>
    </message>
    <message>
        <source>Go to the beginning of the recording</source>
        <translation>記録の最初に移動します</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>最後へ</translation>
    </message>
    <message>
        <source>Go to the end of the recording</source>
        <translation>記録の最後に移動します</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>遅く</translation>
    </message>
    <message>
        <source>Play the recording more slowly, down to a tenth</source>
        <translation>記録をゆっくり再生します（10分の1まで）</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>速く</translation>
    </message>
    <message>
        <source>Play the recording faster, up to 16 times</source>
        <translation>記録を速く再生します（16倍まで）</translation>
    </message>
    <message>
        <source>Compare with …</source>
        <translation>比較する …</translation>
    </message>
    <message>
        <source>Open another attempt beside this one, or close it</source>
        <translation>別の試行をこの試行の隣に開く、または閉じます</translation>
    </message>
    <message>
        <source>Guide my hand</source>
        <translation>手を導く</translation>
    </message>
    <message>
        <source>Let the handpiece guide your hand along the attempt; push against it to stop</source>
        <translation>ハンドピースが手を試行に沿って導きます。押し返すと止まります</translation>
    </message>
    <message>
        <source>Seeing inside</source>
        <translation>内部を見る</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>Show or hide a live section through the bur</source>
        <translation>バーを通る断面を表示、または隠します</translation>
    </message>
    <message>
        <source>Turn the section</source>
        <translation>断面を回す</translation>
    </message>
    <message>
        <source>Turn the section around the bur by 15 degrees</source>
        <translation>バーを中心に断面を15度回します</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>X線</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>表示をリセット</translation>
    </message>
    <message>
        <source>Return to the initial view</source>
        <translation>最初の視点に戻します</translation>
    </message>
    <message>
        <source>Rotate 180°</source>
        <translation>180°回転</translation>
    </message>
    <message>
        <source>Look at the tooth from the opposite side</source>
        <translation>反対側から歯を見ます</translation>
    </message>
    <message>
        <source>Dental mirror</source>
        <extracomment>The small round mirror on a handle</extracomment>
        <translation>デンタルミラー</translation>
    </message>
    <message>
        <source>Show or hide the mirror; drag its glass to move it, with Shift to tilt it</source>
        <translation>ミラーを表示、または隠します。鏡面をドラッグすると動き、Shiftを押すと傾きます</translation>
    </message>
    <message>
        <source>Light on the handpiece</source>
        <translation>ハンドピースのライト</translation>
    </message>
    <message>
        <source>Light the cavity from the handpiece</source>
        <translation>ハンドピースで窩洞を照らします</translation>
    </message>
    <message>
        <source>Depth colours</source>
        <translation>深さの色分け</translation>
    </message>
    <message>
        <source>Colour the cut by its depth and show the depth at the pointer</source>
        <translation>切削面を深さで色分けし、ポインターの位置の値を示します</translation>
    </message>
    <message>
        <source>Deviation from the ideal</source>
        <translation>理想形との色分け</translation>
    </message>
    <message>
        <source>Colour what is too deep and what is still to cut, and show the value at the pointer</source>
        <translation>深すぎる所と残りを色分けし、ポインターの位置の値を示します</translation>
    </message>
    <message>
        <source>Colour the bur</source>
        <extracomment>The bur tells by its colour how near it is to what is to be kept</extracomment>
        <translation>バーの色分け</translation>
    </message>
    <message>
        <source>Colour the bur by its distance from tissue that must be kept</source>
        <translation>残すべき部分への近さをバーの色で示します</translation>
    </message>
    <message>
        <source>Guided hand</source>
        <translation>手の誘導</translation>
    </message>
    <message>
        <source>A gentle force keeps the hand within the outline</source>
        <translation>弱い力で手を外形線の内側に保ちます</translation>
    </message>
    <message>
        <source>Neighbouring teeth</source>
        <translation>隣在歯</translation>
    </message>
    <message>
        <source>Show the adjacent teeth and the gum</source>
        <translation>両隣の歯と歯肉を表示します</translation>
    </message>
    <message>
        <source>Hand position</source>
        <translation>手の位置</translation>
    </message>
    <message>
        <source>Show faintly where the hand holds the bur</source>
        <translation>手がバーを持つ位置を薄く表示します</translation>
    </message>
    <message>
        <source>Colour-blind palette</source>
        <translation>色覚対応の配色</translation>
    </message>
    <message>
        <source>Give each tissue a colour and a pattern that are easy to tell apart</source>
        <translation>各組織に、見分けやすい色と模様を付けます</translation>
    </message>
    <message>
        <source>Wet tooth</source>
        <extracomment>The tooth as if it were wet</extracomment>
        <translation>濡れた歯</translation>
    </message>
    <message>
        <source>Make the tooth shine as if it were wet</source>
        <translation>濡れたように歯を光らせます</translation>
    </message>
    <message>
        <source>Stereo picture</source>
        <translation>立体表示</translation>
    </message>
    <message>
        <source>One picture for each eye</source>
        <translation>左右の目に別々の画像を表示します</translation>
    </message>
    <message>
        <source>Set up the stereo picture …</source>
        <translation>立体表示の設定 …</translation>
    </message>
    <message>
        <source>Choose glasses or screen and fit it to your eyes</source>
        <translation>めがねや画面を選び、目に合わせます</translation>
    </message>
    <message>
        <source>Mirror horizontally</source>
        <translation>左右反転</translation>
    </message>
    <message>
        <source>For a half-silvered mirror over the hand</source>
        <translation>手の上に置いたハーフミラー用</translation>
    </message>
    <message>
        <source>Mirror vertically</source>
        <translation>上下反転</translation>
    </message>
    <message>
        <source>For a screen mounted upside down over the hand</source>
        <translation>手の上に伏せて置いた画面用</translation>
    </message>
    <message>
        <source>Save a picture …</source>
        <translation>画像を保存 …</translation>
    </message>
    <message>
        <source>Save what the view shows as a PNG</source>
        <translation>表示をPNGとして保存します</translation>
    </message>
    <message>
        <source>Less motion</source>
        <translation>動きを減らす</translation>
    </message>
    <message>
        <source>No animations and no spinning bur</source>
        <translation>滑らかな移動とバーの回転を表示しません</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>ウィンドウ</translation>
    </message>
    <message>
        <source>Side panel</source>
        <translation>サイドパネル</translation>
    </message>
    <message>
        <source>Show or hide the figures</source>
        <translation>数値を表示、または隠します</translation>
    </message>
    <message>
        <source>Console</source>
        <translation>コンソール</translation>
    </message>
    <message>
        <source>Show or hide parameters that you can change while you drill</source>
        <translation>切削中に変更できるパラメーターを表示、または隠します</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Every setting with its range</source>
        <translation>すべての設定と範囲</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>ログイン</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>全画面</translation>
    </message>
    <message>
        <source>Fill the whole screen</source>
        <translation>画面全体に表示します</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>キーとマウス</translation>
    </message>
    <message>
        <source>Show what every key does</source>
        <translation>すべてのキーの働きを表示します</translation>
    </message>
    <message>
        <source>Back to the tooth</source>
        <translation>歯に戻る</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Close Cusp</source>
        <translation>Cuspを閉じます</translation>
    </message>
    <message>
        <source>This lesson does not allow it.</source>
        <translation>この課題では使えません。</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>Tooltip: what it does, then its key</extracomment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>自分の試行</translation>
    </message>
    <message>
        <source>See the results of your attempts</source>
        <translation>自分の試行の結果を見ます</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>クラス</translation>
    </message>
    <message>
        <source>See the results of a class and who needs help</source>
        <translation>クラスの成績と、助けが必要な人を見ます</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>ツアーを見る</translation>
    </message>
    <message>
        <source>Get to know the window step by step</source>
        <translation>画面の使い方を順に案内します</translation>
    </message>
    <message>
        <source>School</source>
        <translation>学校</translation>
    </message>
    <message>
        <source>People, class lists, backups and the audit</source>
        <translation>人、クラス名簿、バックアップ、監査記録</translation>
    </message>
    <message>
        <source>Log in, lock this workstation, or change your password or the language</source>
        <translation>ログイン。席のロック、パスワードや言語の変更</translation>
    </message>
    <message>
        <source>Lock or switch user</source>
        <translation>ロック、またはユーザーを切り替え</translation>
    </message>
    <message>
        <source>Your work stays open; a password is needed to continue</source>
        <translation>作業は開いたままです。続けるにはパスワードが必要です</translation>
    </message>
    <message>
        <source>Close this page; nothing is lost</source>
        <translation>このページを閉じます。何も失われません</translation>
    </message>
    <message>
        <source>Back to the attempts</source>
        <translation>試行一覧へ戻る</translation>
    </message>
    <message>
        <source>Back to the class</source>
        <translation>クラスへ戻る</translation>
    </message>
    <message>
        <source>Back to the lessons</source>
        <translation>課題へ戻る</translation>
    </message>
    <message>
        <source>Guest,
unsaved</source>
        <extracomment>Beside &quot;Log in&quot;, on every page: what is done now is kept for nobody. Two short lines.</extracomment>
        <translation>ゲスト
保存なし</translation>
    </message>
    <message>
        <source>Show changes made on other computers</source>
        <translation>ほかのコンピューターで行われた変更を表示します</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>再読み込み</translation>
    </message>
    <message>
        <source>Show X-ray pictures of the tooth, before and now, or close them</source>
        <translation>歯のX線画像（術前と現在）を表示、または閉じます</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Search on this page, or among the lessons</source>
        <translation>このページ、またはレッスンを検索します</translation>
    </message>
    <message>
        <source>Outline</source>
        <extracomment>Of the ideal preparation, drawn on the tooth</extracomment>
        <translation>外形線</translation>
    </message>
    <message>
        <source>Show or hide the outline of the ideal preparation on the tooth</source>
        <translation>理想的な窩洞の外形線を歯の上に表示または非表示にします</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>デバイス</translation>
    </message>
    <message>
        <source>Choose and try what moves the bur</source>
        <translation>バーを動かすものを選び、試す</translation>
    </message>
    <message>
        <source>Straight ahead is here</source>
        <translation>ここを正面にする</translation>
    </message>
    <message>
        <source>Make the present position of your head the middle one</source>
        <translation>現在の頭の位置を中央の位置にする</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>音</translation>
    </message>
    <message>
        <source>Sound of the handpiece on or off</source>
        <translation>ハンドピースの音をオンまたはオフにする</translation>
    </message>
    <message>
        <source>All burs</source>
        <translation>すべてのバー</translation>
    </message>
    <message>
        <source>Choose from all burs, and which are at hand</source>
        <translation>すべてのバーから選び、手元に置くものを決めます</translation>
    </message>
</context>
<context>
    <name>ui::toothchooser::ArchTooth</name>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 is the FDI number, %2 the tooth&apos;s name</extracomment>
        <translation>%1、%2</translation>
    </message>
</context>
<context>
    <name>ui::toothchooser::ArchView</name>
    <message>
        <source>Arches</source>
        <translation>歯列</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
</context>
<context>
    <name>ui::practice::BurChooser</name>
    <message>
        <source>Burs</source>
        <translation>バー</translation>
    </message>
</context>
<context>
    <name>ui::kit::BusyOverlay</name>
    <message>
        <source>Working</source>
        <translation>処理中</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進み具合</translation>
    </message>
</context>
<context>
    <name>ui::practice::DrillSwitch</name>
    <message>
        <source>Drill is on</source>
        <translation>切削はオンです</translation>
    </message>
    <message>
        <source>Drill is off</source>
        <translation>切削はオフです</translation>
    </message>
    <message>
        <source>Drill on</source>
        <translation>切削オン</translation>
    </message>
    <message>
        <source>Drill off</source>
        <translation>切削オフ</translation>
    </message>
</context>
<context>
    <name>ui::kit::FileDialog</name>
    <message>
        <source>%1 is a file of another kind and stays as it is. Choose another name.</source>
        <translation>%1 は別の種類のファイルなので、そのまま残します。別の名前を選んでください。</translation>
    </message>
</context>
<context>
    <name>ui::kit::ForceBar</name>
    <message>
        <source>Force against the force that is set</source>
        <translation>設定された力に対する現在の力</translation>
    </message>
    <message>
        <source>The mark is the force that is set. A wall that presses sideways adds to it.</source>
        <translation>印は設定された力です。横から押す壁の力が加わります。</translation>
    </message>
</context>
<context>
    <name>ui::practice::HandControls</name>
    <message>
        <source>Feed</source>
        <translation>送り速度</translation>
    </message>
    <message>
        <source>Feed, millimetres per second</source>
        <translation>送り速度（mm/秒）</translation>
    </message>
    <message>
        <source>How fast the bur goes down at most while you press</source>
        <translation>押している間にバーが下がる最大速度</translation>
    </message>
    <message>
        <source>Depth stop</source>
        <translation>深さストップ</translation>
    </message>
    <message>
        <source>The bur stops at this depth below the original surface</source>
        <translation>元の表面からこの深さでバーが止まります</translation>
    </message>
    <message>
        <source>Depth stop, millimetres</source>
        <translation>深さストップ（mm）</translation>
    </message>
    <message>
        <source>To change the depth, turn the mouse wheel while you press the button or hold Shift</source>
        <translation>深さを変えるには、ボタンまたはShiftキーを押したままホイールを回します</translation>
    </message>
    <message>
        <source>Push with</source>
        <translation>押す力</translation>
    </message>
    <message>
        <source>Push with, newtons</source>
        <translation>押す力（ニュートン）</translation>
    </message>
    <message>
        <source>How hard the mouse and the keys push the bur against the tooth at most</source>
        <translation>マウスとキーがバーを歯に押し付ける最大の力</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>The %1 moves the bur. Feed, depth stop and force are for the mouse.</source>
        <extracomment>%1: a force device</extracomment>
        <translation>%1 がバーを動かします。送り、深さストップ、力はマウス用です。</translation>
    </message>
</context>
<context>
    <name>ui::practice::HandpieceChooser</name>
    <message>
        <source>Handpieces</source>
        <translation>ハンドピース</translation>
    </message>
</context>
<context>
    <name>ui::window::HelpOverlay</name>
    <message>
        <source>Move the bur</source>
        <translation>バーを動かす</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>マウス</translation>
    </message>
    <message>
        <source>arrows</source>
        <translation>矢印キー</translation>
    </message>
    <message>
        <source>Move it in fine steps</source>
        <translation>細かく動かす</translation>
    </message>
    <message>
        <source>Shift + arrows</source>
        <translation>Shift + 矢印</translation>
    </message>
    <message>
        <source>Push it against the tooth</source>
        <translation>歯に押し当てる</translation>
    </message>
    <message>
        <source>left button</source>
        <translation>左ボタン</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Page Down</translation>
    </message>
    <message>
        <source>Lift it</source>
        <translation>引き上げる</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Page Up</translation>
    </message>
    <message>
        <source>Push harder, softer</source>
        <translation>強く・弱く押す</translation>
    </message>
    <message>
        <source>Depth stop</source>
        <translation>深さストップ</translation>
    </message>
    <message>
        <source>wheel while pressed</source>
        <translation>押しながらホイール</translation>
    </message>
    <message>
        <source>Shift + wheel</source>
        <translation>Shift + ホイール</translation>
    </message>
    <message>
        <source>Insert, Delete</source>
        <translation>Insert、Delete</translation>
    </message>
    <message>
        <source>Ctrl + wheel</source>
        <translation>Ctrl + ホイール</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>視点を回す</translation>
    </message>
    <message>
        <source>right or middle drag</source>
        <translation>右または中ドラッグ</translation>
    </message>
    <message>
        <source>Ctrl + arrows</source>
        <translation>Ctrl + 矢印</translation>
    </message>
    <message>
        <source>Turn the handpiece</source>
        <translation>ハンドピースを回す</translation>
    </message>
    <message>
        <source>the same with Shift</source>
        <translation>同じ操作 + Shift</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>表示をリセット</translation>
    </message>
    <message>
        <source>right double-click</source>
        <translation>右ダブルクリック</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>Move the mirror</source>
        <translation>ミラーを動かす</translation>
    </message>
    <message>
        <source>drag its glass</source>
        <translation>鏡面をドラッグ</translation>
    </message>
    <message>
        <source>Alt + arrows</source>
        <translation>Alt + 矢印</translation>
    </message>
    <message>
        <source>Tilt the mirror</source>
        <translation>ミラーを傾ける</translation>
    </message>
    <message>
        <source>Bring it nearer</source>
        <translation>近づける</translation>
    </message>
    <message>
        <source>wheel over it</source>
        <translation>上でホイール</translation>
    </message>
    <message>
        <source>Alt + Page Up</source>
        <translation>Alt + Page Up</translation>
    </message>
    <message>
        <source>Zoom in, zoom out</source>
        <translation>拡大・縮小</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>ホイール</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>閉じる（Esc）</translation>
    </message>
    <message>
        <source>The teal arc beside the bur shows how hard it presses; it is full at the force that is set.</source>
        <translation>バーの横の青緑の弧は押す強さを示します。設定された力で満ちます。</translation>
    </message>
    <message>
        <source>Over the tooth</source>
        <translation>歯の上で</translation>
    </message>
    <message>
        <source>In a list</source>
        <translation>一覧で</translation>
    </message>
    <message>
        <source>Change the sorting</source>
        <translation>並べ替えを変える</translation>
    </message>
</context>
<context>
    <name>ui::scoring::RecentScoresChart</name>
    <message>
        <source>%1 with another rubric</source>
        <translation>%1（別の評価基準）</translation>
    </message>
    <message>
        <source>Last grades, oldest first: %1</source>
        <translation>最近の成績（古い順）：%1</translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation>合格点%1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: date and time; %2: what the grade of then came to</extracomment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>ui::kit::LanguageMenu</name>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
</context>
<context>
    <name>ui::window::FileDialogs</name>
    <message>
        <source>The comparison was saved as %1.</source>
        <translation>比較を%1として保存しました。</translation>
    </message>
    <message>
        <source>The comparison could not be written. Choose another folder, or make room on the disk.</source>
        <translation>比較を書き込めませんでした。別のフォルダーを選ぶか、ディスクの空きを増やしてください。</translation>
    </message>
    <message>
        <source>The picture was saved as %1.</source>
        <translation>画像を%1として保存しました。</translation>
    </message>
    <message>
        <source>The picture could not be written. Choose another folder, or free some disk space.</source>
        <translation>画像を書き込めませんでした。別のフォルダーを選ぶか、ディスクの空きを増やしてください。</translation>
    </message>
    <message>
        <source>Scans of teeth (%1)</source>
        <translation>歯のスキャン (%1)</translation>
    </message>
    <message>
        <source>Recordings (%1)</source>
        <translation>記録 (%1)</translation>
    </message>
    <message>
        <source>Captured ideals (%1)</source>
        <translation>取り込んだ理想形 (%1)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>画像 (%1)</translation>
    </message>
    <message>
        <source>Hardness presets (%1)</source>
        <translation>硬さのプリセット (%1)</translation>
    </message>
    <message>
        <source>Tables (%1)</source>
        <translation>表 (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
</context>
<context>
    <name>ui::window::UnsavedWork</name>
    <message>
        <source>Your work would be lost.</source>
        <translation>切削した内容が失われます。</translation>
    </message>
    <message>
        <source>Your latest cuts are not saved as a recording.</source>
        <translation>最後の切削以降、記録として保存されていません。</translation>
    </message>
    <message>
        <source>&amp;Save the recording …</source>
        <translation>記録を保存(&amp;S) …</translation>
    </message>
    <message>
        <source>The exam would end without a score.</source>
        <translation>試験は採点されないまま中断されます。</translation>
    </message>
    <message>
        <source>It still counts as an attempt. Your work cannot be graded later.</source>
        <translation>それでも1回の試行として数えられます。切削したものは後から採点できません。</translation>
    </message>
    <message>
        <source>&amp;Grade it now</source>
        <translation>今すぐ採点(&amp;G)</translation>
    </message>
    <message numerus="yes">
        <source>%n grade(s) are not saved yet and would be lost.</source>
        <translation>
            <numerusform>%n 件の評価がまだ保存されておらず、失われます。</numerusform>
        </translation>
    </message>
    <message>
        <source>The disk cannot be written to. Cusp tries again every few seconds while it runs. Free some disk space, or check the permissions of the folder.</source>
        <translation>現在ディスクに書き込めません。Cuspの起動中は数秒ごとにもう一度試みます。ディスクの空きを増やすか、フォルダーの権限を確認してください。</translation>
    </message>
</context>
<context>
    <name>ui::window::CommandSender</name>
    <message>
        <source>Cusp was still busy and did not do that. Try again.</source>
        <translation>Cuspは前の処理中のため、その操作を行いませんでした。もう一度お試しください。</translation>
    </message>
</context>
<context>
    <name>ui::window::Notices</name>
    <message numerus="yes">
        <source>%n note(s) about this scan</source>
        <translation>
            <numerusform>このスキャンに関する注意%n件</numerusform>
        </translation>
    </message>
    <message>
        <source>Another unit</source>
        <translation>別の単位</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>Keep this unit</source>
        <translation>この単位のままにする</translation>
    </message>
    <message>
        <source>The recording was saved as %1.</source>
        <translation>記録を%1として保存しました。</translation>
    </message>
    <message>
        <source>This is neither a scan (OBJ, STL, PLY) nor a recording. Drop one of those.</source>
        <translation>スキャン（OBJ、STL、PLY）でも記録でもありません。どちらかをドロップしてください。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>You had no attempts left at this lesson, so this grade is not saved.</source>
        <translation>この課題の試行回数はすでに使い切られているため、この成績は保存されません。</translation>
    </message>
    <message>
        <source>You can save your work as a recording.</source>
        <translation>作業は記録として保存できます。</translation>
    </message>
    <message>
        <source>The school&apos;s database does not answer yet. You can continue drilling; your request is completed when it answers.</source>
        <translation>学校のデータベースがまだ応答しません。切削は続けられます。要求した内容は、応答があり次第処理されます。</translation>
    </message>
</context>
<context>
    <name>ui::window::ResumeOffer</name>
    <message>
        <source>%1: an attempt of %2 was not finished.</source>
        <extracomment>%1: &quot;Tooth 36&quot;, &quot;Practice block: line&quot;; %2: a time of today, or a day and a time</extracomment>
        <translation>%1：%2の試行が未完了です。</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>再開</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>The attempt was discarded; it is kept for seven days.</source>
        <translation>試行を破棄しました。7日間保管されます。</translation>
    </message>
    <message>
        <source>Restore it</source>
        <translation>復元する</translation>
    </message>
    <message>
        <source>&amp;Continue it</source>
        <translation>続ける(&amp;G)</translation>
    </message>
    <message>
        <source>This exam would be discarded without a score.</source>
        <translation>この試験は得点なしで破棄されます。</translation>
    </message>
    <message>
        <source>It still counts as an attempt. You can restore it right afterwards.</source>
        <translation>それでも1回の試行として数えられます。直後であればまだ元に戻せます。</translation>
    </message>
</context>
<context>
    <name>ui::window::LessonController</name>
    <message>
        <source>The time for this lesson is over. Continue as long as you like, or press G for the grade.</source>
        <translation>この課題の時間が終わりました。好きなだけ続けるか、Gで採点してください。</translation>
    </message>
    <message>
        <source>Another attempt at the exam begins.</source>
        <translation>試験の新しい試行を始めます。</translation>
    </message>
    <message>
        <source>The exercise starts again.</source>
        <translation>練習を最初から始めます。</translation>
    </message>
    <message>
        <source>The tooth was reset.</source>
        <translation>歯をリセットしました。</translation>
    </message>
    <message>
        <source>Restore my work</source>
        <translation>作業を復元</translation>
    </message>
    <message>
        <source>Only a tooth with decay has an ideal preparation.</source>
        <translation>理想形があるのは、う蝕のある歯だけです。</translation>
    </message>
    <message>
        <source>Another attempt at the lesson begins.</source>
        <translation>課題の新しい試行を始めます。</translation>
    </message>
    <message>
        <source>The time for this exam is over: cutting is disabled.</source>
        <translation>この試験の時間は終わりました。これ以上切削できません。</translation>
    </message>
    <message>
        <source>This exam is over but not graded yet. Press G to grade it.</source>
        <translation>この試験は終わりましたが、まだ採点されていません。Gで採点します。</translation>
    </message>
    <message>
        <source>Another attempt begins.</source>
        <translation>新しい試行を始めます。</translation>
    </message>
    <message>
        <source>The outline is not available in an exam.</source>
        <translation>試験では外形線を使用できません。</translation>
    </message>
    <message>
        <source>This tooth has no ideal preparation.</source>
        <translation>この歯には理想的な窩洞がありません。</translation>
    </message>
    <message>
        <source>This attempt has lasted six hours, the longest that Cusp records: cutting is disabled. Press G for the grade, or R for another attempt.</source>
        <translation>この試行は、Cuspが記録できる最長の6時間に達しました。これ以上は切削できません。Gキーで採点するか、Rキーで新しい試行を始めてください。</translation>
    </message>
</context>
<context>
    <name>ui::window::PracticeController</name>
    <message>
        <source>You can undo the stroke.</source>
        <translation>「元に戻す」でこのストロークを取り消せます。</translation>
    </message>
    <message>
        <source>Tooth perforated</source>
        <translation>歯に穿孔しました</translation>
    </message>
    <message>
        <source>Pulp opened</source>
        <translation>露髄しました</translation>
    </message>
</context>
<context>
    <name>ui::window::ReplayView</name>
    <message>
        <source>You pushed against the guidance, so it stopped. Press A to start it again.</source>
        <translation>押し返したため、誘導を終えました。もう一度誘導を始めるにはAを押してください。</translation>
    </message>
    <message>
        <source>The handpiece is no longer available, so the guidance stopped.</source>
        <translation>ハンドピースが使えなくなったため、誘導を終えました。</translation>
    </message>
    <message>
        <source>The recording has ended.</source>
        <translation>記録の終わりです。</translation>
    </message>
    <message>
        <source>Stop the replay</source>
        <translation>再生を停止</translation>
    </message>
    <message>
        <source>From a file …</source>
        <translation>ファイルから …</translation>
    </message>
</context>
<context>
    <name>ui::window::HardnessController</name>
    <message>
        <source>Import a hardness preset</source>
        <translation>硬さのプリセットを読み込む</translation>
    </message>
    <message>
        <source>Export the hardness preset</source>
        <translation>硬さのプリセットを書き出す</translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation>比較を保存</translation>
    </message>
    <message>
        <source>The hardness preset was saved: %1.</source>
        <translation>硬さのプリセットを保存しました：%1。</translation>
    </message>
    <message>
        <source>It feels like %1 now.</source>
        <extracomment>%1 is a hardness preset</extracomment>
        <translation>手応えは%1になりました。</translation>
    </message>
    <message>
        <source>The hardness cannot be changed during an exam.</source>
        <translation>試験中は硬さを変更できません。</translation>
    </message>
    <message>
        <source>A replay uses the recorded hardness.</source>
        <translation>再生では記録時の硬さを使います。</translation>
    </message>
    <message>
        <source>A blind comparison of two presets is running. Finish it first.</source>
        <translation>2つのプリセットをブラインド比較中です。先に比較を終えてください。</translation>
    </message>
    <message>
        <source>This lesson sets its own hardness. Only the forces can be changed.</source>
        <translation>この課題には固有の硬さがあります。変更できるのは力だけです。</translation>
    </message>
    <message>
        <source>There is no hardness preset &quot;%1&quot;. There are: %2.</source>
        <translation>硬さプリセット「%1」はありません。あるもの：%2。</translation>
    </message>
</context>
<context>
    <name>ui::window::AccountController</name>
    <message>
        <source>The one-time code is no longer valid. Ask an admin for a new one.</source>
        <translation>ワンタイムコードは無効になりました。新しいコードを管理者に依頼してください。</translation>
    </message>
</context>
<context>
    <name>ui::window::LessonEditing</name>
    <message>
        <source>The lesson editor is not available during an exam, because it shows the ideal. Press G to finish the exam, or start another lesson.</source>
        <translation>課題エディターは理想形を表示するため、試験中は使えません。Gで試験を終えるか、別の課題を始めてください。</translation>
    </message>
    <message>
        <source>This file is not a valid lesson, so it cannot be edited. Fix the listed errors first.</source>
        <translation>このファイルは有効な課題ではないため、編集できません。先に示された誤りを直してください。</translation>
    </message>
    <message>
        <source>Only teachers can edit lessons: log in as a teacher. To practise the lesson, choose it in the list.</source>
        <translation>課題を変更できるのは教員です。教員としてログインしてください。課題を行うには一覧から選んでください。</translation>
    </message>
</context>
<context>
    <name>ui::window::MainWindow</name>
    <message>
        <source>Save the X-ray pictures</source>
        <translation>X線画像を保存</translation>
    </message>
    <message>
        <source>Cusp</source>
        <translation>Cusp</translation>
    </message>
    <message>
        <source>This is a replay. Stop it to grade your own work.</source>
        <translation>再生中です。ご自身の作業の採点を受けるには停止してください。</translation>
    </message>
    <message>
        <source>You cannot drill from below: the bur is on the other side of the tooth. Turn the tooth back, or press V.</source>
        <translation>下からは切削できません：バーは歯の反対側で動いています。向きを戻すか、Vを押してください。</translation>
    </message>
    <message>
        <source>The simulated handpiece is active</source>
        <extracomment>Beside the name of the tooth, where otherwise &quot;lower left first molar&quot; stands</extracomment>
        <translation>模擬ハンドピースが作業中です</translation>
    </message>
    <message>
        <source>%1 – Cusp</source>
        <extracomment>%1: a lesson; %2: a person and a date</extracomment>
        <translation>%1 – Cusp</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
</context>
<context>
    <name>ui::kit::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>Close this message (Esc)</source>
        <translation>このメッセージを閉じます（Esc）</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>このメッセージを閉じる</translation>
    </message>
</context>
<context>
    <name>ui::toothchooser::Mouth</name>
    <message>
        <source>This computer cannot draw the whole mouth. Use the flat arches instead.</source>
        <translation>このコンピューターでは口腔全体を描けません。代わりに平面の歯列を使ってください。</translation>
    </message>
    <message>
        <source>Whole mouth</source>
        <translation>口腔全体</translation>
    </message>
    <message>
        <source>Arrow keys move along the arch, Enter selects the tooth.</source>
        <translation>矢印キーで歯列をたどり、Enterで歯を選びます。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Creating the teeth …</source>
        <translation>歯を作成しています …</translation>
    </message>
    <message>
        <source>Selected. Press Enter or double-click to use it.</source>
        <translation>選択中です。Enterまたはダブルクリックで決定します。</translation>
    </message>
    <message>
        <source>Click to select it.</source>
        <translation>クリックして選びます。</translation>
    </message>
    <message>
        <source>Only teeth of the left side can be drilled; %1 is its mirror image.</source>
        <translation>切削できるのは左側の歯だけです。%1がその鏡像です。</translation>
    </message>
    <message>
        <source>Right button turns, wheel zooms. From above or below you see one jaw.</source>
        <translation>右ボタンで回転、ホイールで拡大縮小。上または下からは片顎が見えます。</translation>
    </message>
</context>
<context>
    <name>ui::window::PracticeRoom</name>
    <message>
        <source>Move the mouse over the tooth, press the left button to drill; right-drag turns the view; F1 for keys</source>
        <translation>マウスを歯の上で動かし、左ボタンを押すと切削します。右ドラッグで視点を回します。F1でキーの一覧</translation>
    </message>
    <message>
        <source>This attempt</source>
        <translation>この試行</translation>
    </message>
</context>
<context>
    <name>ui::kit::ConfirmOverlay</name>
    <message>
        <source>&amp;Discard</source>
        <translation>破棄(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Stay</source>
        <translation>このままにする(&amp;S)</translation>
    </message>
</context>
<context>
    <name>ui::kit::ScoreBar</name>
    <message>
        <source>%1 of 100, pass mark %2</source>
        <extracomment>A score bar for the screen reader</extracomment>
        <translation>100点中%1点、合格点%2</translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation>合格点%1</translation>
    </message>
</context>
<context>
    <name>ui::kit::ScrollPane</name>
    <message>
        <source>More than there is room for</source>
        <translation>画面に収まらない内容</translation>
    </message>
    <message>
        <source>Page Up, Page Down and the arrow keys scroll</source>
        <translation>Page Up、Page Down、矢印キーでスクロールします</translation>
    </message>
</context>
<context>
    <name>ui::practice::SidePanel</name>
    <message>
        <source>Live figures and handpiece</source>
        <translation>現在の数値とハンドピース</translation>
    </message>
    <message>
        <source>Under the bur</source>
        <translation>バーの下</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深さ</translation>
    </message>
    <message>
        <source>Depth of the tip below the original surface. No value is shown at the edge of the tooth, where a vertical depth means little.</source>
        <translation>元の表面からの先端の深さです。垂直の深さに意味のない歯の縁では表示しません。</translation>
    </message>
    <message>
        <source>To the pulp</source>
        <translation>歯髄まで</translation>
    </message>
    <message>
        <source>Shortest distance from the head of the bur to the pulp, downwards or sideways. Leave two millimetres; less than half a millimetre harms the pulp.</source>
        <translation>バーの頭部から歯髄までの、下方または側方の最短距離です。2 mmを残してください。0.5 mm未満では歯髄を傷つけます。</translation>
    </message>
    <message>
        <source>To the limit</source>
        <extracomment>How far the bur is from what is to be kept</extracomment>
        <translation>限界まで</translation>
    </message>
    <message>
        <source>Distance from the head of the bur to tissue that must be kept, downwards or sideways. No value is shown above one millimetre.</source>
        <translation>バーの頭部から残すべき部分までの下方または側方の距離です。1 mmを超える間は表示しません。</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>除去量</translation>
    </message>
    <message>
        <source>Area of opened pulp, seen from above. The grade uses this figure.</source>
        <translation>上から見た、露出した歯髄の面積です。採点ではこの値を使います。</translation>
    </message>
    <message>
        <source>Bur</source>
        <translation>バー</translation>
    </message>
    <message>
        <source>Speed of the bur in revolutions per minute. Load slows it down until it stalls</source>
        <translation>バーの毎分回転数：負荷で遅くなり、やがて止まります</translation>
    </message>
    <message>
        <source>Handpiece</source>
        <translation>ハンドピース</translation>
    </message>
    <message>
        <source>Air</source>
        <comment>the bur touches nothing</comment>
        <translation>空中</translation>
    </message>
    <message>
        <source>rpm</source>
        <extracomment>Turns a minute</extracomment>
        <translation>rpm</translation>
    </message>
    <message>
        <source>N, limited</source>
        <extracomment>Unit of the force while the wanted force is beyond what the device may give</extracomment>
        <translation>N、上限</translation>
    </message>
    <message>
        <source>N, %1 sideways</source>
        <extracomment>Unit of the force, and how much of it comes from a wall that presses sideways</extracomment>
        <translation>N、側方%1</translation>
    </message>
    <message>
        <source>&lt; 1</source>
        <translation>&lt; 1</translation>
    </message>
    <message>
        <source>The handpiece touches the crown, so the bur cannot go deeper.</source>
        <translation>ハンドピースが歯冠に当たっています：これより深くは届きません。</translation>
    </message>
    <message>
        <source>Decay left</source>
        <extracomment>Of what is to be taken away: decay, or the preparation that is asked for</extracomment>
        <translation>残りのう蝕</translation>
    </message>
    <message>
        <source>Still to cut</source>
        <translation>残りの切削</translation>
    </message>
    <message>
        <source>beside the decay</source>
        <translation>う蝕の周囲</translation>
    </message>
    <message>
        <source>beyond the ideal</source>
        <translation>理想形の外側</translation>
    </message>
    <message>
        <source>Block</source>
        <extracomment>What a practice block is made of, in place of &quot;Enamel&quot;</extracomment>
        <translation>ブロック</translation>
    </message>
</context>
<context>
    <name>ui::practice::StereoCard</name>
    <message>
        <source>Stereo picture</source>
        <translation>立体表示</translation>
    </message>
    <message>
        <source>Way to the eyes</source>
        <translation>両眼への表示方法</translation>
    </message>
    <message>
        <source>Red and cyan glasses, in colour</source>
        <translation>赤青めがね、カラー</translation>
    </message>
    <message>
        <source>Red and cyan glasses, in grey</source>
        <translation>赤青めがね、グレー</translation>
    </message>
    <message>
        <source>Halves side by side</source>
        <translation>左右に分割</translation>
    </message>
    <message>
        <source>Halves one above the other</source>
        <translation>上下に分割</translation>
    </message>
    <message>
        <source>Distance of the eyes</source>
        <translation>両眼の間隔</translation>
    </message>
    <message>
        <source>Plane of the screen</source>
        <translation>画面の面</translation>
    </message>
    <message>
        <source>1. How do the two pictures reach your eyes? Close one eye, then the other: each must see a single tooth.</source>
        <translation>1. 2つの画像をどのように両眼へ届けますか？ 片目ずつ閉じてください。それぞれの目に歯が1つだけ見えるはずです。</translation>
    </message>
    <message>
        <source>2. Move the eyes apart until the cusps stand up from the fissures, and back a little if it tires you.</source>
        <translation>2. 咬頭が裂溝から浮き上がって見えるまで両眼の間隔を広げ、疲れるようなら少し戻してください。</translation>
    </message>
    <message>
        <source>3. Move the tooth before or behind the screen until you see it without effort.</source>
        <translation>3. 楽に見えるまで、歯を画面の前後に動かしてください。</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Without stereo</source>
        <translation>立体表示なし</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Discard the changes (Esc)</source>
        <translation>変更を破棄します（Esc）</translation>
    </message>
</context>
<context>
    <name>ui::toothchooser::ToothChooser</name>
    <message>
        <source>Choose a tooth</source>
        <translation>歯を選ぶ</translation>
    </message>
    <message>
        <source>Drill this tooth</source>
        <translation>この歯を切削</translation>
    </message>
    <message>
        <source>Practise on this tooth (Enter)</source>
        <translation>この歯で練習します（Enter）</translation>
    </message>
    <message>
        <source>Or drill your own tooth: a scan as an OBJ, STL or PLY file. You can also drop the file anywhere on this window.</source>
        <translation>ご自身の歯も切削できます：OBJ、STL、PLYのスキャン。このウィンドウにファイルをドロップすることもできます。</translation>
    </message>
    <message>
        <source>Flat arches</source>
        <translation>平面の歯列</translation>
    </message>
    <message>
        <source>Whole mouth</source>
        <translation>口腔全体</translation>
    </message>
    <message>
        <source>No tooth selected</source>
        <translation>未選択</translation>
    </message>
    <message>
        <source>In use. Choosing it again resets it.</source>
        <translation>使用中の歯です。もう一度選ぶとリセットされます。</translation>
    </message>
    <message>
        <source>Click a tooth, or use the arrow keys.</source>
        <translation>歯をクリックするか、矢印キーで移動してください。</translation>
    </message>
</context>
<context>
    <name>ui::window::Tour</name>
    <message>
        <source>Move the bur with the mouse and press the left button to drill. Drag with the right button to turn the view.</source>
        <translation>マウスでバーを動かし、左ボタンを押すと切削します。右ボタンでドラッグすると視点が回ります。</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>すべての課題</translation>
    </message>
    <message>
        <source>The lessons that come with Cusp, and your own. Search for a word or the number of a tooth.</source>
        <translation>Cuspに付属の課題と自作の課題です。言葉または歯の番号で検索できます。</translation>
    </message>
    <message>
        <source>Change a lesson</source>
        <translation>課題を変更する</translation>
    </message>
    <message>
        <source>Change the goal and the rubric of a lesson, and see the effect on earlier attempts.</source>
        <translation>課題の内容と採点を変更し、これまでの試行がどう変わるかを確かめられます。</translation>
    </message>
    <message>
        <source>Your classes</source>
        <translation>担当クラス</translation>
    </message>
    <message>
        <source>Here you see who needs help and how everybody is doing. Assign lessons, open attempts, replay them, and write comments.</source>
        <translation>助けが必要な人と全員の成績が分かります。課題を割り当て、試行を開いて再生し、コメントを書けます。</translation>
    </message>
    <message>
        <source>Try it yourself</source>
        <translation>自分で試す</translation>
    </message>
    <message>
        <source>The grade</source>
        <translation>採点</translation>
    </message>
    <message>
        <source>Your work is measured, and the score card shows where and when each point was lost.</source>
        <translation>作業が計測され、どの点をどこでいつ失ったかが成績表に示されます。</translation>
    </message>
    <message>
        <source>Classes</source>
        <translation>クラス</translation>
    </message>
    <message>
        <source>The results of every class in every lesson, as its teachers see them.</source>
        <translation>各クラスの課題ごとの成績を、教員と同じ画面で見られます。</translation>
    </message>
    <message>
        <source>How it feels</source>
        <translation>手応え</translation>
    </message>
    <message>
        <source>Burs, force and depth are here. The hardness presets (F7) set how hard teeth are.</source>
        <translation>バー、力、深さはここにあります。歯の硬さは硬さのプリセット（F7）で決めます。</translation>
    </message>
    <message>
        <source>The tooth</source>
        <translation>歯</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>Choose here what to practise. Lessons assigned to your class come first.</source>
        <translation>練習する内容をここで選びます。クラスに割り当てられた課題が先に並びます。</translation>
    </message>
    <message>
        <source>Choose here what to practise. Each lesson states its goal and how it is graded.</source>
        <translation>練習する内容をここで選びます。各課題に内容と採点方法が書かれています。</translation>
    </message>
    <message>
        <source>Bur, force and depth</source>
        <translation>バー、力、深さ</translation>
    </message>
    <message>
        <source>Change the bur, set how hard the mouse presses, and read force and depth while you drill.</source>
        <translation>バーの交換やマウスの押す力の設定ができ、切削中の力と深さを読み取れます。</translation>
    </message>
    <message>
        <source>Seeing inside</source>
        <translation>内部を見る</translation>
    </message>
    <message>
        <source>A live section through the bur shows enamel, dentin and pulp, where the lesson allows it.</source>
        <translation>課題が許す場合、バーを通る断面でエナメル質、象牙質、歯髄が見られます。</translation>
    </message>
    <message>
        <source>See how your scores develop, read your instructor&apos;s comments, and replay every attempt.</source>
        <translation>点数の推移と教員のコメントが見られ、どの試行も再生できます。</translation>
    </message>
    <message>
        <source>Your account</source>
        <translation>アカウント</translation>
    </message>
    <message>
        <source>Log in to save your grades. Without a login, nothing is saved.</source>
        <translation>ログインすると成績が保存されます。ログインしないと何も保存されません。</translation>
    </message>
    <message>
        <source>Lock the window when you leave, or switch user.</source>
        <translation>席を離れるときはロックするか、ユーザーを切り替えてください。</translation>
    </message>
    <message>
        <source>Every key</source>
        <translation>すべてのキー</translation>
    </message>
    <message>
        <source>All keys are listed here. You can also start this tour again from there.</source>
        <translation>すべてのキーの一覧です。このツアーもそこからもう一度見られます。</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>ツアー</translation>
    </message>
    <message>
        <source>Skip the tour</source>
        <translation>ツアーを終了</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>Steps of a tour: &quot;2 of 6&quot;</extracomment>
        <translation>%1／%2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>次へ</translation>
    </message>
    <message>
        <source>The school</source>
        <translation>学校</translation>
    </message>
    <message>
        <source>Add people one by one or from a list, assign them to classes, and manage backups and the audit.</source>
        <translation>利用者を一人ずつ、または名簿から登録し、クラスに入れます。バックアップと監査記録もここで管理します。</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>自分の試行</translation>
    </message>
</context>
<context>
    <name>ui::kit::UnsavedChanges</name>
    <message>
        <source>Discard your unsaved changes?</source>
        <extracomment>%1: a user</extracomment>
        <translation>保存していない変更を破棄しますか？</translation>
    </message>
    <message>
        <source>Discard the unsaved changes of %1?</source>
        <translation>%1 の保存していない変更を破棄しますか？</translation>
    </message>
    <message>
        <source>&amp;Keep editing</source>
        <translation>編集を続ける(&amp;K)</translation>
    </message>
</context>
<context>
    <name>ui::practice::ViewMenu</name>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Choose what the view shows</source>
        <translation>表示する内容を選びます</translation>
    </message>
    <message>
        <source>Look from</source>
        <translation>見る方向</translation>
    </message>
    <message>
        <source>Occlusal</source>
        <translation>咬合面</translation>
    </message>
    <message>
        <source>Buccal</source>
        <translation>頬側</translation>
    </message>
    <message>
        <source>Lingual</source>
        <translation>舌側</translation>
    </message>
    <message>
        <source>Mesial</source>
        <translation>近心</translation>
    </message>
    <message>
        <source>Distal</source>
        <translation>遠心</translation>
    </message>
    <message>
        <source>Apical</source>
        <translation>根尖側</translation>
    </message>
</context>
<context>
    <name>ui::scoring::AdviceWords</name>
    <message>
        <source>You drilled right through the tooth. Check the depth in the section while you go down.</source>
        <translation>歯を貫通しました。下げながら断面で深さを確かめてください。</translation>
    </message>
    <message>
        <source>The bur went down at %1 mm/s when it opened the pulp. Go down slowly, and stop when the floor is firm dentin.</source>
        <extracomment>%1 is a speed in mm/s</extracomment>
        <translation>バーは毎秒%1 mmで下がり、歯髄を露出させました。ゆっくり下げ、窩底が硬い象牙質になったら止めてください。</translation>
    </message>
    <message>
        <source>You opened the pulp. Check in the section how much dentin is left before you go deeper, and stop when the floor is firm dentin.</source>
        <translation>歯髄を露出させました。さらに深く削る前に断面で残りの象牙質を確かめ、窩底が硬い象牙質になったら止めてください。</translation>
    </message>
    <message>
        <source>The pulp chamber is not open yet. Go on at the place that the X-ray shows until its roof is gone.</source>
        <translation>髄室がまだ開いていません。エックス線写真が示す場所で、天蓋がなくなるまで続けてください。</translation>
    </message>
    <message>
        <source>%1 % of the decay is still in the tooth. Clean the walls first and then the floor, until no brown is left.</source>
        <extracomment>%1 is a share in per cent</extracomment>
        <translation>う蝕の%1 %が残っています。まず側壁、次に窩底を、茶色がなくなるまで取り除いてください。</translation>
    </message>
    <message>
        <source>The bur went down at %1 mm/s into sound tissue. Lift it as soon as the figure turns yellow.</source>
        <extracomment>%1 is a speed in mm/s</extracomment>
        <translation>バーは毎秒%1 mmで健全な歯質に入りました。数字が黄色になったらすぐに上げてください。</translation>
    </message>
    <message>
        <source>You removed %1 mm³ of sound tissue. Follow the brown edge, and take a smaller bur near it.</source>
        <extracomment>%1 is a volume in mm³</extracomment>
        <translation>健全な歯質を%1 mm³削りました。茶色の縁に沿って進み、その近くでは小さいバーを使ってください。</translation>
    </message>
    <message>
        <source>Enamel is left without dentin under it. Remove the overhanging edge.</source>
        <translation>下に象牙質のないエナメル質が残っています。張り出した縁を取り除いてください。</translation>
    </message>
    <message>
        <source>The bur went down at %1 mm/s and past the floor. Go down slowly, or set the depth stop.</source>
        <extracomment>%1 is a speed in mm/s</extracomment>
        <translation>バーは毎秒%1 mmで窩底を越えました。ゆっくり下げるか、深さストップを設定してください。</translation>
    </message>
    <message>
        <source>The floor is up to %1 mm too deep. Set the depth stop to the depth that the lesson asks for.</source>
        <translation>窩底が最大%1 mm深すぎます。深さストップをレッスンが求める深さに設定してください。</translation>
    </message>
    <message>
        <source>The floor is too deep. Set the depth stop to the depth that the lesson asks for.</source>
        <translation>窩底が深すぎます。深さストップをレッスンが求める深さに設定してください。</translation>
    </message>
    <message>
        <source>The floor is up to %1 mm too high. Lower it with the depth stop at the depth that the lesson asks for.</source>
        <translation>窩底が最大%1 mm浅すぎます。深さストップをレッスンが求める深さにして下げてください。</translation>
    </message>
    <message>
        <source>%1 % of the preparation is still standing. Compare with the outline and cut what is left inside it.</source>
        <extracomment>%1 is a share in per cent</extracomment>
        <translation>形成すべき部分の%1 %が残っています。外形と比べ、その内側に残った部分を削ってください。</translation>
    </message>
    <message>
        <source>You cut up to %1 mm outside the outline. Keep the edge of the bur, not its middle, on the line.</source>
        <translation>外形の外側を最大%1 mm削りました。バーの中心ではなく縁を線に合わせてください。</translation>
    </message>
    <message>
        <source>You cut outside the outline. Keep the edge of the bur, not its middle, on the line.</source>
        <translation>外形の外側を削りました。バーの中心ではなく縁を線に合わせてください。</translation>
    </message>
    <message>
        <source>The outline stays up to %1 mm inside the ideal one. Widen the cavity to the line.</source>
        <translation>外形が理想より最大%1 mm内側です。線まで窩洞を広げてください。</translation>
    </message>
    <message>
        <source>The marginal ridge is only %1 mm wide; it should keep %2 mm. Stop earlier on the way to the ridge.</source>
        <extracomment>%1 and %2 are lengths in mm</extracomment>
        <translation>辺縁隆線の幅が%1 mmしかありません。%2 mm残してください。隆線の手前で早めに止めてください。</translation>
    </message>
    <message>
        <source>The isthmus is %1 mm too wide. Go through it once, with a bur that is not wider than it.</source>
        <translation>イスムスが%1 mm広すぎます。幅を越えないバーで一度だけ通してください。</translation>
    </message>
    <message>
        <source>The isthmus is %1 mm too narrow. Widen it evenly on both sides.</source>
        <translation>イスムスが%1 mm狭すぎます。両側を均等に広げてください。</translation>
    </message>
    <message>
        <source>A wall leans %1° from the ideal. Move the bur along the wall in one stroke at full depth.</source>
        <translation>側壁が理想から%1°傾いています。十分な深さで壁に沿って一続きに動かしてください。</translation>
    </message>
    <message>
        <source>The floor is uneven. Keep the depth stop on, and sweep the floor in strokes that overlap.</source>
        <translation>窩底が平らではありません。深さストップを入れたまま、重なるように窩底を掃いてください。</translation>
    </message>
    <message>
        <source>Too little is done to judge this. Finish the preparation first.</source>
        <translation>評価するには作業が足りません。まず形成を終えてください。</translation>
    </message>
    <message>
        <source>You pushed too hard. Let the bur do the work.</source>
        <translation>押す力が強すぎます。バーに任せてください。</translation>
    </message>
    <message>
        <source>Watch the gauge and change the force slowly until it stays in the range.</source>
        <translation>ゲージを見ながら、範囲内に収まるまで力をゆっくり変えてください。</translation>
    </message>
    <message>
        <source>You took longer than asked. Plan the strokes before you begin.</source>
        <translation>求められた時間より長くかかりました。始める前に動きを考えてください。</translation>
    </message>
    <message>
        <source>Some points are not touched yet. The ring marks one of them.</source>
        <translation>まだ触れていない点があります。その一つに輪が付いています。</translation>
    </message>
    <message>
        <source>Touch each pad slowly again: enamel is hardest, dentin yields, decay is soft.</source>
        <translation>各面にもう一度ゆっくり触れてください。エナメル質が最も硬く、象牙質は少し沈み、う蝕は軟らかいです。</translation>
    </message>
    <message>
        <source>You cut the tooth. In this exercise the bur only touches it: do not press the drill.</source>
        <translation>歯を削りました。この練習ではバーで触れるだけです。回転させないでください。</translation>
    </message>
    <message>
        <source>Only %1 mm of dentin is left over the pulp. Watch the figure for the remaining dentin, and stop earlier.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>歯髄上に残る象牙質は%1 mmだけです。残存象牙質の数値を見て、早めに止めてください。</translation>
    </message>
    <message>
        <source>You cut the tooth %1 mm away from the decay. Lift the bur before you move it, and cut at the decay only.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>う蝕から%1 mm離れた所を切削しました。動かす前にバーを離し、う蝕だけを切削してください。</translation>
    </message>
    <message>
        <source>The cavity goes %1 mm below the decay. Stop as soon as no brown is left at the bottom.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>窩洞がう蝕より%1 mm深くなっています。底の茶色がなくなったら止めてください。</translation>
    </message>
    <message>
        <source>The floor is still in enamel. Lower it until it lies just inside dentin.</source>
        <translation>窩底がまだエナメル質内です。象牙質にわずかに入るまで下げてください。</translation>
    </message>
    <message>
        <source>The floor is tilted by %1°. Keep the depth stop on, and compare both ends in the section.</source>
        <translation>窩底が%1°傾いています。深さストッパーを使い、断面で両端を比べてください。</translation>
    </message>
    <message>
        <source>The turning bur touched the neighbouring tooth. Leave a thin shell of enamel towards it, and break it off last.</source>
        <translation>回転中のバーが隣在歯に触れました。隣側に薄いエナメル質を残し、最後に除去してください。</translation>
    </message>
    <message>
        <source>The walls are wavy. Go along each wall once more with the side of the bur, in one light stroke.</source>
        <translation>壁が波打っています。バーの側面で、軽い一続きのストロークで各壁をもう一度なぞってください。</translation>
    </message>
    <message>
        <source>Only %1 mm of the oblique ridge is left; it should keep %2 mm. Stop earlier on both sides of it.</source>
        <extracomment>%1 and %2 are lengths in mm</extracomment>
        <translation>斜走隆線が%1 mmしか残っていません。%2 mm残す必要があります。両側でもっと手前で止めてください。</translation>
    </message>
    <message>
        <source>The gingival floor is %1 mm off the height that the lesson asks for. Check its depth in the section before you widen the box.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>歯肉側窩底の高さが課題の値から%1 mmずれています。ボックスを広げる前に、断面で深さを確かめてください。</translation>
    </message>
    <message>
        <source>The axial wall of the box is %1 mm too far inside the tooth. Compare the depth of the box with the width of the bur before you go on inwards.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>ボックスの軸側壁が%1 mm内側に入りすぎています。さらに内側へ進む前に、ボックスの奥行きをバーの幅と比べてください。</translation>
    </message>
    <message>
        <source>The axial wall of the box is %1 mm too far outside. Move the bur inwards along the whole wall.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>ボックスの軸側壁が%1 mm外側にあります。壁全体に沿ってバーを内側へ進めてください。</translation>
    </message>
    <message>
        <source>The %1 mm pit is %2 mm too deep. Lift the bur sooner, and compare the depth with the head of the bur.</source>
        <extracomment>%1 and %2 are lengths in mm</extracomment>
        <translation>%1 mmの穴が%2 mm深すぎます。早めにバーを上げ、深さをバーの頭部と比べてください。</translation>
    </message>
    <message>
        <source>The %1 mm pit is %2 mm too shallow. Go down in short steps, and compare the depth with the head of the bur.</source>
        <extracomment>%1 and %2 are lengths in mm</extracomment>
        <translation>%1 mmの穴が%2 mm浅すぎます。少しずつ下げ、深さをバーの頭部と比べてください。</translation>
    </message>
    <message>
        <source>You cut %1 mm³ of dentin. Stop as soon as the bur sinks more easily and the floor looks yellow.</source>
        <extracomment>%1 is a volume in mm³</extracomment>
        <translation>象牙質を%1 mm³切削しました。バーが軽く沈み、窩底が黄色く見えたらすぐに止めてください。</translation>
    </message>
    <message>
        <source>Up to %1 mm of enamel is left on the floor. Cut on with light strokes until the bur meets less resistance.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>窩底にエナメル質が最大%1 mm残っています。抵抗が減るまで軽いストロークで切削を続けてください。</translation>
    </message>
    <message>
        <source>%1 % of the soft decay is still in the tooth. Remove it from the walls and the floor until the bur meets more resistance.</source>
        <extracomment>%1 is a share in per cent</extracomment>
        <translation>軟らかいう蝕の%1 %が歯に残っています。バーの抵抗が増えるまで、壁と窩底から除去してください。</translation>
    </message>
    <message>
        <source>Leathery decay is left on %1 mm² that do not lie over the pulp. Remove it there down to firm dentin.</source>
        <extracomment>%1 is an area in mm²</extracomment>
        <translation>歯髄の上ではない%1 mm²に、革様のう蝕が残っています。そこでは硬い象牙質まで除去してください。</translation>
    </message>
    <message>
        <source>Decay is left at the enamel-dentin junction on %1 mm². Clean the junction all the way round.</source>
        <extracomment>%1 is an area in mm²</extracomment>
        <translation>エナメル象牙境の%1 mm²にう蝕が残っています。境界を全周にわたり除去してください。</translation>
    </message>
    <message>
        <source>The cavity goes %1 mm deeper than the decay that had to be removed. Stop at firm dentin, and over the pulp at leathery dentin.</source>
        <extracomment>%1 is a length in mm</extracomment>
        <translation>窩洞は、除去すべきう蝕より%1 mm深くなっています。硬い象牙質で、歯髄の上では革様の象牙質で止めてください。</translation>
    </message>
    <message>
        <source>A marginal ridge that should stay is %1 mm thinner than it should be. Stop earlier on the way to the ridge.</source>
        <translation>残すべき辺縁隆線が%1 mm薄くなっています。隆線に近づいたら、より手前で止めてください。</translation>
    </message>
</context>
<context>
    <name>ui::scoring::ConductNotes</name>
    <message>
        <source>%1 in total, %2 of it cutting</source>
        <extracomment>Two times in minutes and seconds</extracomment>
        <translation>全体%1、うち切削%2</translation>
    </message>
    <message>
        <source>force: mean %1 N, maximum %2 N</source>
        <translation>力 平均%1 N、最大%2 N</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) undone</source>
        <translation>
            <numerusform>取り消し%n回</numerusform>
        </translation>
    </message>
    <message>
        <source>No breach of the rules</source>
        <translation>規則違反はありません</translation>
    </message>
    <message numerus="yes">
        <source>%n breach(es) of the rules</source>
        <translation>
            <numerusform>規則違反%n件</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Replay the attempt from this moment</source>
        <translation>この時点から試行を再生します</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>breaches</comment>
        <translation>
            <numerusform>ほか%n件</numerusform>
        </translation>
    </message>
    <message>
        <source>Show every breach</source>
        <translation>すべての違反を表示します</translation>
    </message>
</context>
<context>
    <name>ui::scoring::CriterionRow</name>
    <message>
        <source>%1 work incomplete</source>
        <extracomment>%1: points of a score that is earned only when enough of the work is done</extracomment>
        <translation>%1 作業不足</translation>
    </message>
    <message>
        <source>%1 not measured</source>
        <extracomment>%1: points of a score. What could not be measured earns nothing</extracomment>
        <translation>%1 測定なし</translation>
    </message>
    <message>
        <source>%1 too late</source>
        <extracomment>%1: points of a score, for something that was done later than asked</extracomment>
        <translation>%1 遅すぎ</translation>
    </message>
    <message>
        <source>%1 not removed</source>
        <translation>%1 除去されず</translation>
    </message>
    <message>
        <source>%1 not achieved</source>
        <extracomment>Of a criterion that was not fulfilled at any time</extracomment>
        <translation>%1 未達成</translation>
    </message>
    <message>
        <source>%1 at %2, stroke %3</source>
        <extracomment>%1: points lost, %2: minutes and seconds of the attempt, %3: number of a stroke of the bur</extracomment>
        <translation>%1（%2、ストローク%3）</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>The exposed area, seen from above. The side panel shows the removed volume, in mm³.</source>
        <translation>上から見た露出面積です。除去した体積はサイドパネルにmm³で表示されます。</translation>
    </message>
    <message>
        <source>The attempt fails and all remaining points are lost</source>
        <extracomment>Tooltip on the points of one criterion</extracomment>
        <translation>不合格となり、残りの点をすべて失います</translation>
    </message>
    <message>
        <source>At most %1 points can be lost here</source>
        <translation>ここでの失点は最大%1点です</translation>
    </message>
    <message>
        <source>%1: %2, %3 points</source>
        <extracomment>A row of a score, for the screen reader: %1 a criterion, %2 what was measured, %3 the points it cost</extracomment>
        <translation>%1：%2、%3点</translation>
    </message>
    <message>
        <source>Show the worst place</source>
        <translation>最も悪い箇所を表示します</translation>
    </message>
    <message>
        <source>Replay the attempt from this moment</source>
        <translation>この時点から試行を再生します</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <comment>moments at which points were lost</comment>
        <translation>
            <numerusform>ほか%n件</numerusform>
        </translation>
    </message>
    <message>
        <source>Show every moment</source>
        <translation>すべての時点を表示します</translation>
    </message>
    <message>
        <source>This error limits the score to %1 points</source>
        <translation>この誤りにより得点は最大%1点になります</translation>
    </message>
</context>
<context>
    <name>ui::practice::ExerciseCard</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is &quot;Left&quot;, &quot;Middle&quot; or &quot;Right&quot;, %2 a tissue</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Choose this material for the pad; you can change it until you are graded</source>
        <translation>このパッドの材質としてこれを選びます。採点までは変更できます</translation>
    </message>
    <message>
        <source>✓ right</source>
        <extracomment>Beside what the student took a pad for; %1 is the tissue that it is</extracomment>
        <translation>✓ 正解</translation>
    </message>
    <message>
        <source>✗ it is %1</source>
        <translation>✗ 正しくは%1</translation>
    </message>
    <message numerus="yes">
        <source>All %n points touched</source>
        <translation>
            <numerusform>%n個の点すべてに触れました</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 points touched</source>
        <translation>%2点中%1点に触れました</translation>
    </message>
    <message>
        <source>Held for %1 s</source>
        <extracomment>%1 is a time in seconds</extracomment>
        <translation>%1秒保持しました</translation>
    </message>
    <message>
        <source>Hold %1 N for %2 s</source>
        <translation>%1 Nを%2秒保持してください</translation>
    </message>
    <message>
        <source>of %1 s</source>
        <extracomment>Behind the seconds that a force has been held: of how many</extracomment>
        <translation>／%1秒</translation>
    </message>
    <message>
        <source>The materials of the pads</source>
        <translation>各パッドの材質</translation>
    </message>
    <message>
        <source>Every pad has an answer</source>
        <translation>すべてのパッドに回答しました</translation>
    </message>
    <message>
        <source>What is each pad made of?</source>
        <translation>それぞれのパッドは何でできていますか？</translation>
    </message>
    <message>
        <source>Graded. Press F2 for the next lesson.</source>
        <translation>採点済みです。F2を押すと次の課題へ進めます。</translation>
    </message>
    <message>
        <source>Well done. Press G for your grade.</source>
        <translation>よくできました。Gを押して採点してください。</translation>
    </message>
    <message>
        <source>Sure? Then press G for your grade.</source>
        <translation>よろしければ、Gを押して採点してください。</translation>
    </message>
    <message>
        <source>The bur is turning. Stop it with the space bar: this exercise needs no cutting.</source>
        <translation>バーが回転しています。スペースキーで止めてください。この練習では切削しません。</translation>
    </message>
    <message>
        <source>Start the bur with the space bar: while it is stopped, all three feel the same.</source>
        <translation>スペースキーでバーを回してください：止まっていると3つとも同じ手応えです。</translation>
    </message>
    <message>
        <source>Longest so far: %1 s</source>
        <extracomment>%1 is a time in seconds</extracomment>
        <translation>これまでの最長：%1秒</translation>
    </message>
    <message>
        <source>Any order. A ring becomes a disc when touched.</source>
        <translation>順番は自由です。触れた輪は円板になります。</translation>
    </message>
    <message>
        <source>Anywhere on the tooth.</source>
        <translation>歯のどこでも構いません。</translation>
    </message>
    <message>
        <source>Press on each for a second, and compare.</source>
        <translation>それぞれを1秒ずつ押して、比べてください。</translation>
    </message>
</context>
<context>
    <name>ui::scoring::FeedbackCard</name>
    <message>
        <source>%1 commented on your attempt: %2</source>
        <extracomment>%1: a teacher; %2: a lesson</extracomment>
        <translation>%1 さんがあなたの試行についてコメントしました: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n of your attempts have new feedback</source>
        <translation>
            <numerusform>%n 件の試行に新しい講評があります</numerusform>
        </translation>
    </message>
    <message>
        <source>Read</source>
        <translation>読む</translation>
    </message>
    <message>
        <source>My attempts</source>
        <translation>自分の試行</translation>
    </message>
</context>
<context>
    <name>ui::scoring::ScorePredictionPage</name>
    <message>
        <source>How many points do you expect?</source>
        <translation>何点だと思いますか？</translation>
    </message>
    <message>
        <source>What cost you most?</source>
        <translation>最も失点したのは何だと思いますか？</translation>
    </message>
    <message>
        <source>Show the score</source>
        <translation>得点を見る</translation>
    </message>
    <message>
        <source>Show how your work was graded (Enter)</source>
        <translation>採点の内容を見ます（Enter）</translation>
    </message>
    <message>
        <source>Before you see the score</source>
        <translation>得点を見る前に</translation>
    </message>
    <message>
        <source>%1. The pass mark is %2 of 100 points. You learn more from a score if you assess your own work first.</source>
        <extracomment>%1 is a lesson, %2 the mark that is needed</extracomment>
        <translation>%1。100点中%2点で合格です。先に自分の作業を評価してから得点を見ると、より多くを学べます。</translation>
    </message>
    <message>
        <source>Set the points that you expect.</source>
        <translation>予想する点数を設定してください。</translation>
    </message>
</context>
<context>
    <name>ui::scoring::HeatMap</name>
    <message>
        <source>The tooth from above, coloured by what is too deep and what is still to cut</source>
        <translation>上から見た歯。深すぎる所と残りを色分けしています</translation>
    </message>
    <message>
        <source>as it should be</source>
        <translation>適正</translation>
    </message>
    <message>
        <source>%1 mm too deep</source>
        <translation>%1 mm深すぎます</translation>
    </message>
    <message>
        <source>%1 mm still to cut</source>
        <translation>残り%1 mm</translation>
    </message>
    <message>
        <source>still to cut</source>
        <translation>残り</translation>
    </message>
    <message>
        <source>too deep</source>
        <translation>深すぎ</translation>
    </message>
    <message>
        <source>To mark the place of a comment, click the tooth or use the arrow keys. Delete removes the mark.</source>
        <translation>歯をクリックするか矢印キーで、コメントの対象となる場所に印を付けます。Deleteで印が消えます。</translation>
    </message>
</context>
<context>
    <name>ui::practice::HoldGauge</name>
    <message>
        <source>Force in relation to the range from %1 to %2 N</source>
        <translation>%1～%2 Nの範囲に対する力</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::IdealForm</name>
    <message>
        <source>What the ideal is</source>
        <translation>理想形の種類</translation>
    </message>
    <message>
        <source>Take recordings as the reference …</source>
        <translation>記録を基準にする …</translation>
    </message>
    <message>
        <source>Choose one attempt, or several whose mean is to be cut</source>
        <translation>1つの試行、または平均を目標とする複数の試行を選びます</translation>
    </message>
    <message>
        <source>The ideal is the decay itself: nothing is to be set</source>
        <translation>理想形はう蝕そのものです：設定するものはありません</translation>
    </message>
    <message>
        <source>An exercise: nothing is to be cut</source>
        <translation>練習：切削するものはありません</translation>
    </message>
    <message>
        <source>Ideal preparation</source>
        <translation>理想的な窩洞形成</translation>
    </message>
    <message>
        <source>By rule</source>
        <extracomment>%1: the name of a file</extracomment>
        <translation>規則による</translation>
    </message>
    <message>
        <source>Captured: %1</source>
        <translation>取り込み：%1</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <extracomment>%1 and %2: the least and the greatest number that can be set; %3: a unit</extracomment>
        <translation>%1～%2 %3</translation>
    </message>
</context>
<context>
    <name>ui::practice::InfractionCard</name>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Restore the tooth as it was before this; you can redo it (Enter)</source>
        <translation>この前の状態に歯を戻します。やり直すこともできます（Enter）</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>続ける</translation>
    </message>
    <message>
        <source>Keep the tooth as it is and continue (Esc)</source>
        <translation>歯をそのままにして作業を続けます（Esc）</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::LessonEditor</name>
    <message>
        <source>Not saved: %1</source>
        <translation>保存されていません：%1</translation>
    </message>
    <message>
        <source>Not saved: whoever cuts exactly this ideal would lose points. Widen the tolerances that are named, or press Fit.</source>
        <translation>保存されていません：この理想形どおりに切削しても減点されます。示された許容範囲を広げるか、「合わせる」を押してください。</translation>
    </message>
    <message>
        <source>Not saved: there is a file %1 already. Open that lesson instead.</source>
        <translation>保存されていません：ファイル%1がすでにあります。代わりにその課題を開いてください。</translation>
    </message>
    <message>
        <source>Lesson editor</source>
        <translation>課題エディター</translation>
    </message>
    <message>
        <source>Title of the lesson</source>
        <translation>課題の題名</translation>
    </message>
    <message>
        <source>Lesson editor: %1</source>
        <translation>課題エディター：%1</translation>
    </message>
    <message>
        <source>On the tooth</source>
        <translation>歯の上で</translation>
    </message>
    <message>
        <source>What the tolerances mean on the tooth</source>
        <translation>許容範囲が歯の上で意味するもの</translation>
    </message>
    <message>
        <source>Past attempts</source>
        <translation>過去の試行</translation>
    </message>
    <message>
        <source>How attempts would score under other tolerances</source>
        <translation>許容範囲を変えたときの試行の得点</translation>
    </message>
    <message>
        <source>The lesson&apos;s file</source>
        <translation>課題のファイル</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>The lesson as its file says it</source>
        <translation>ファイルの内容そのままの課題</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save the lesson</source>
        <translation>課題を保存</translation>
    </message>
    <message>
        <source>Write the lesson into your folder (Ctrl+S)</source>
        <translation>課題をあなたのフォルダーに書き込みます（Ctrl+S）</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>合わせる</translation>
    </message>
    <message>
        <source>Widen the tolerances until the ideal itself loses nothing</source>
        <translation>理想形自体の減点がなくなるまで許容範囲を広げます</translation>
    </message>
    <message>
        <source>Fit the tolerances to the ideal</source>
        <translation>許容範囲を理想形に合わせる</translation>
    </message>
    <message>
        <source>This lesson of yours is changed where it stands.</source>
        <translation>あなたのこの課題は、その場所で変更されます。</translation>
    </message>
    <message>
        <source>A shipped lesson: saved, it becomes one of your own, based on it.</source>
        <translation>付属の課題です。保存すると、これを元にしたあなたの課題になります。</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>まだ保存されていません。</translation>
    </message>
    <message>
        <source>This rubric has no criterion that can be drawn on the tooth.</source>
        <translation>この評価基準には、歯の上に描ける評価項目がありません。</translation>
    </message>
    <message>
        <source>Costs nothing: %1.</source>
        <translation>減点なし：%1。</translation>
    </message>
    <message>
        <source>Wrong: %1</source>
        <extracomment>%1: where in the lesson, and what is wrong there</extracomment>
        <translation>誤り：%1</translation>
    </message>
    <message>
        <source>The ideal is checked as soon as nothing is wrong.</source>
        <translation>誤りがなくなり次第、理想形を検査します。</translation>
    </message>
    <message>
        <source>An exercise has no ideal that could be checked.</source>
        <translation>練習には検査できる理想形がありません。</translation>
    </message>
    <message>
        <source>The ideal scores %1 on itself</source>
        <translation>理想形自体の得点は%1です</translation>
    </message>
    <message>
        <source>The ideal scores only %1 on itself; it loses at: %2</source>
        <translation>理想形自体の得点が%1しかありません。失点：%2</translation>
    </message>
    <message>
        <source>Not measured or not earned on this ideal, so no tolerance helps: %1. Mark by another rubric.</source>
        <translation>この理想形では測定されない、または得点できないため、許容範囲では解決しません：%1。別の評価基準を使ってください。</translation>
    </message>
    <message>
        <source>Take recordings as the reference …</source>
        <translation>記録を基準にする …</translation>
    </message>
    <message>
        <source>Recordings (%1)</source>
        <translation>記録 (%1)</translation>
    </message>
    <message numerus="yes">
        <source>Replaying %n recording(s) …</source>
        <translation>
            <numerusform>%n件の記録を再生しています …</numerusform>
        </translation>
    </message>
    <message>
        <source>No reference was made: %1</source>
        <translation>基準を作れませんでした：%1</translation>
    </message>
    <message>
        <source>The reference is %1 beside your lessons.</source>
        <translation>基準は、課題と同じ場所の%1です。</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>%1として保存しました。</translation>
    </message>
    <message>
        <source>The lesson needs a title.</source>
        <translation>課題には題名が必要です。</translation>
    </message>
    <message>
        <source>Not saved: %1 has been changed since you opened it, in another window or at another computer. Open it anew to see that; a step back then brings your own changes back, to be saved in its place.</source>
        <translation>保存されていません：%1は、あなたが開いた後に別のウィンドウまたは別のコンピューターで変更されました。開き直すとその内容が表示されます。その後「元に戻す」で自分の変更に戻り、代わりに保存できます。</translation>
    </message>
    <message>
        <source>Open anew</source>
        <translation>開き直す</translation>
    </message>
    <message>
        <source>Show what stands in the file now; a step back brings your own changes back</source>
        <translation>ファイルの現在の内容を表示します。「元に戻す」で自分の変更に戻ります</translation>
    </message>
    <message>
        <source>%1 is no lesson as it stands now, and was not opened. Look at it with whoever has changed it.</source>
        <translation>%1は現在の内容では課題ではないため、開かれませんでした。変更した人と一緒に確認してください。</translation>
    </message>
    <message>
        <source>This is what stands in the file now. A step back brings your own changes back.</source>
        <translation>これがファイルの現在の内容です。「元に戻す」で自分の変更に戻ります。</translation>
    </message>
    <message numerus="yes">
        <source>What you have changed in %n lesson(s) would be lost.</source>
        <translation>
            <numerusform>%n件の課題の変更が失われます。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::catalog::LessonPicture</name>
    <message>
        <source>What the lesson asks for, as a picture</source>
        <translation>課題が求める内容の画像</translation>
    </message>
    <message>
        <source>This tooth cannot be created.</source>
        <translation>この歯は作成できません。</translation>
    </message>
    <message>
        <source>Creating the tooth …</source>
        <translation>歯を作成しています …</translation>
    </message>
</context>
<context>
    <name>ui::practice::LessonStrip</name>
    <message>
        <source>Previous step</source>
        <translation>前の手順</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>次の手順</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>ヒント</translation>
    </message>
    <message>
        <source>Show a hint for this step</source>
        <translation>この手順のヒントを表示します</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <extracomment>A step of the work, and how many there are</extracomment>
        <translation>%1／%2</translation>
    </message>
    <message>
        <source>The exam is over and cutting is disabled. Press G for the score or R for another attempt.</source>
        <translation>試験は終わりました。これ以上切削できません。Gで得点を表示、Rで新しい試行を始めます。</translation>
    </message>
    <message>
        <source>Working time</source>
        <translation>作業時間</translation>
    </message>
    <message>
        <source>Remaining time of %1</source>
        <translation>%1のうちの残り時間</translation>
    </message>
    <message>
        <source>The exam is over and cutting is disabled. Press G for the score.</source>
        <translation>試験は終わりました。これ以上切削できません。Gで得点を表示します。</translation>
    </message>
    <message>
        <source>Remove the brown decay. Stop when the floor is firm dentin.</source>
        <translation>茶色のう蝕を取り除いてください。窩底が硬い象牙質になったら止めます。</translation>
    </message>
    <message>
        <source>The decay is out. Press G for the score.</source>
        <translation>う蝕は除去されました。Gキーで採点します。</translation>
    </message>
</context>
<context>
    <name>ui::catalog::LessonsPage</name>
    <message>
        <source>Lessons</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>Search: a word, or the number of a tooth</source>
        <translation>検索：言葉または歯の番号</translation>
    </message>
    <message>
        <source>Search the lessons</source>
        <translation>課題を検索</translation>
    </message>
    <message>
        <source>Clear the search</source>
        <translation>検索を消去</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Start this lesson</source>
        <translation>この課題を開始</translation>
    </message>
    <message>
        <source>Load the tooth of this lesson (Enter)</source>
        <translation>この課題の歯を用意します（Enter）</translation>
    </message>
    <message>
        <source>Your own lessons …</source>
        <translation>あなたの課題 …</translation>
    </message>
    <message>
        <source>Open the folder for lessons that teachers add</source>
        <translation>教員が追加する課題のフォルダーを開きます</translation>
    </message>
    <message>
        <source>Open the folder of your own lessons</source>
        <translation>あなたの課題のフォルダーを開く</translation>
    </message>
    <message>
        <source>Invalid file</source>
        <translation>無効なファイル</translation>
    </message>
    <message>
        <source>exam</source>
        <translation>試験</translation>
    </message>
    <message>
        <source>changed, not saved</source>
        <extracomment>Of a lesson in a list: in the editor</extracomment>
        <translation>変更あり、未保存</translation>
    </message>
    <message>
        <source>best %1, passed</source>
        <extracomment>For a screen reader: the best score of a lesson</extracomment>
        <translation>最高%1点、合格</translation>
    </message>
    <message>
        <source>best %1, not passed</source>
        <translation>最高%1点、不合格</translation>
    </message>
    <message>
        <source>This file is not a valid lesson. The other lessons work.</source>
        <translation>このファイルは有効な課題ではありません。ほかの課題は使えます。</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>歯</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Exam: mistakes are recorded and reported at the end; undo is disabled</source>
        <translation>試験：誤りは記録され、最後に伝えます。「元に戻す」は使えません</translation>
    </message>
    <message>
        <source>Practice: mistakes are reported at once</source>
        <translation>練習：誤りはその場で伝えます</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Burs</source>
        <translation>バー</translation>
    </message>
    <message>
        <source>Aids</source>
        <translation>補助</translation>
    </message>
    <message>
        <source>Rubric</source>
        <extracomment>%1 is the name of a rubric, %2 the mark that is needed</extracomment>
        <translation>評価基準</translation>
    </message>
    <message>
        <source>%1, passed from %2</source>
        <translation>%1、%2点から合格</translation>
    </message>
    <message>
        <source>Not modelled</source>
        <translation>再現されないもの</translation>
    </message>
    <message>
        <source>Your best</source>
        <translation>最高点</translation>
    </message>
    <message numerus="yes">
        <source>%1 in %n attempt(s)</source>
        <translation>
            <numerusform>%1（試行%n回）</numerusform>
        </translation>
    </message>
    <message>
        <source>Error</source>
        <translation>誤り</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>注意</translation>
    </message>
    <message>
        <source>Tooth …</source>
        <translation>歯…</translation>
    </message>
    <message>
        <source>Lessons on one tooth</source>
        <translation>一本の歯の課題</translation>
    </message>
    <message>
        <source>Choose a tooth in the arch to see its lessons</source>
        <translation>歯列から歯を選び、その課題を見る</translation>
    </message>
    <message>
        <source>All</source>
        <extracomment>All lessons</extracomment>
        <translation>すべて</translation>
    </message>
    <message>
        <source>To do</source>
        <extracomment>Lessons that are still to be done</extracomment>
        <translation>未完了</translation>
    </message>
    <message>
        <source>Passed</source>
        <extracomment>Lessons that were passed</extracomment>
        <translation>合格</translation>
    </message>
    <message>
        <source>Exams</source>
        <translation>試験</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Discard the unfinished attempt</source>
        <translation>途中の試行を破棄する</translation>
    </message>
    <message>
        <source>Continue %1, started %2</source>
        <extracomment>%1: a lesson or a tooth; %2: a time of today, or a day and a time</extracomment>
        <translation>続ける：%1（%2 開始）</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>続ける</translation>
    </message>
    <message>
        <source>Last attempt: %1, best so far %2</source>
        <extracomment>%1: a lesson; %2: points</extracomment>
        <translation>最後に試した課題：%1、最高 %2</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>もう一度</translation>
    </message>
    <message>
        <source>Assigned to you, but not on this computer: %1. Ask your teacher for the file.</source>
        <translation>出されていますが、このコンピューターにありません：%1。先生にファイルをもらってください。</translation>
    </message>
    <message>
        <source>Assigned to you</source>
        <translation>出された課題</translation>
    </message>
    <message>
        <source>No matching lessons</source>
        <translation>該当する課題がありません</translation>
    </message>
    <message>
        <source>Search for another word, or show all lessons.</source>
        <translation>別の言葉で検索するか、すべての課題を表示してください。</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) left</source>
        <translation>
            <numerusform>残り %n 回</numerusform>
        </translation>
    </message>
    <message>
        <source>Assigned to</source>
        <translation>出された先</translation>
    </message>
    <message>
        <source>There are no such lessons now. Show all lessons.</source>
        <translation>該当する課題は今はありません。すべての課題を表示してください。</translation>
    </message>
    <message>
        <source>Loading the lessons …</source>
        <translation>課題を読み込んでいます …</translation>
    </message>
    <message>
        <source>no score yet</source>
        <translation>まだ得点なし</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>制限なし</translation>
    </message>
    <message>
        <source>%1 graded so far</source>
        <extracomment>Of attempts at a lesson; follows &quot;2 attempts left, &quot;</extracomment>
        <translation>これまでに%1回採点</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::RubricForm</name>
    <message>
        <source>Targets and spans</source>
        <translation>目標値と幅</translation>
    </message>
    <message>
        <source>What each measure ought to be, and how far beyond the tolerance all points are lost</source>
        <translation>各測定値の目標と、許容範囲をどれだけ超えると全点を失うか</translation>
    </message>
    <message>
        <source>Marking</source>
        <translation>採点</translation>
    </message>
    <message>
        <source>Passed from</source>
        <translation>合格点</translation>
    </message>
    <message>
        <source>points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>合格点</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>許容範囲</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>配点</translation>
    </message>
    <message>
        <source>Tolerance of: %1</source>
        <extracomment>%1: a criterion</extracomment>
        <translation>許容範囲：%1</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>Weight of: %1</source>
        <translation>配点：%1</translation>
    </message>
    <message>
        <source>Target</source>
        <extracomment>What a measure ought to be</extracomment>
        <translation>目標値</translation>
    </message>
    <message>
        <source>Target of: %1</source>
        <translation>目標値：%1</translation>
    </message>
    <message>
        <source>all lost over</source>
        <extracomment>How far beyond the tolerance all points of a criterion are lost</extracomment>
        <translation>全失点までの幅</translation>
    </message>
    <message>
        <source>Span of: %1</source>
        <translation>幅：%1</translation>
    </message>
    <message>
        <source>All weights: %1 points</source>
        <translation>配点の合計：%1点</translation>
    </message>
    <message>
        <source>All weights: %1 points; they must make 100</source>
        <translation>配点の合計：%1点。100点にしてください</translation>
    </message>
    <message>
        <source>at most %1</source>
        <extracomment>%1: the points that an error leaves at most</extracomment>
        <translation>最大%1点</translation>
    </message>
</context>
<context>
    <name>ui::scoring::ScoreHistory</name>
    <message>
        <source>Log in and save</source>
        <translation>ログインして保存</translation>
    </message>
    <message numerus="yes">
        <source>Of the best results of %n people in your class, %1 % are below this.</source>
        <extracomment>%1 is a number of per cent</extracomment>
        <translation>
            <numerusform>クラスの%n人の最高結果のうち、%1 %がこれより下です。</numerusform>
        </translation>
    </message>
    <message>
        <source>No comparison with a class: to keep results anonymous it needs %1 people, and yours is the only result.</source>
        <extracomment>%1 is a number of people</extracomment>
        <translation>クラスとの比較はできません：個人が特定されないよう%1人必要ですが、ここにあるのはあなたの結果だけです。</translation>
    </message>
    <message numerus="yes">
        <source>No comparison with a class: to keep results anonymous it needs %1 people, and there are results of %n person(s).</source>
        <extracomment>%1 is a number of people</extracomment>
        <translation>
            <numerusform>クラスとの比較はできません：個人が特定されないよう%1人必要ですが、ここにある結果は%n人分です。</numerusform>
        </translation>
    </message>
    <message>
        <source>other rubric</source>
        <extracomment>Beside an earlier grade that cannot be compared with this one</extracomment>
        <translation>別の評価基準</translation>
    </message>
    <message>
        <source>You are not logged in, so this grade is not saved.</source>
        <translation>ログインしていないため、この成績は保存されません。</translation>
    </message>
    <message>
        <source>This grade is saved on this computer. It is sent to the school&apos;s database when the connection is back.</source>
        <translation>この成績はこのコンピューターに保存されています。接続が回復すると、学校のデータベースに送られます。</translation>
    </message>
    <message>
        <source>No earlier grades.</source>
        <translation>以前の成績はありません。</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>試行</translation>
    </message>
    <message>
        <source>This grade is not saved yet. Cusp tries again every few seconds while it runs. Free some disk space.</source>
        <translation>この評価はまだ保存されていません。Cuspの起動中は数秒ごとにもう一度試みます。ディスクの空きを増やしてください。</translation>
    </message>
    <message>
        <source>This grade is not saved and will not be here next time.</source>
        <translation>この成績は保存されません。次回はここに表示されません。</translation>
    </message>
</context>
<context>
    <name>ui::scoring::ScorePage</name>
    <message>
        <source>Does not count</source>
        <translation>数えられません</translation>
    </message>
    <message>
        <source>You expected %1 points, which is exactly right.</source>
        <translation>予想は%1点：ぴったりです。</translation>
    </message>
    <message>
        <source>You expected %1 points. You overestimated by %2 points.</source>
        <translation>予想は%1点：実際より%2点高く見積もりました。</translation>
    </message>
    <message>
        <source>You expected %1 points. You underestimated by %2 points.</source>
        <translation>予想は%1点：実際より%2点低く見積もりました。</translation>
    </message>
    <message>
        <source>You lost no points.</source>
        <translation>失点はありません。</translation>
    </message>
    <message>
        <source>Your biggest loss: %1.</source>
        <translation>最も失点したもの：%1。</translation>
    </message>
    <message>
        <source>You named your biggest loss correctly: %1.</source>
        <translation>最も失点したものを当てました：%1。</translation>
    </message>
    <message>
        <source>You expected &quot;%1&quot; to be your biggest loss; it was &quot;%2&quot;.</source>
        <translation>最も失点したのは「%1」との予想でしたが、「%2」でした。</translation>
    </message>
    <message>
        <source>%1: %2, no answer</source>
        <extracomment>%1 is &quot;Left&quot;, &quot;Middle&quot; or &quot;Right&quot;, %2 and %3 are tissues</extracomment>
        <translation>%1：%2、回答なし</translation>
    </message>
    <message>
        <source>%1: %2, correct</source>
        <translation>%1：%2、正解</translation>
    </message>
    <message>
        <source>%1: %2, your answer: %3</source>
        <translation>%1：%2、回答は%3</translation>
    </message>
    <message>
        <source>Held for %1 of %2 s, mean deviation %3 N</source>
        <translation>%2秒中%1秒保持、平均%3 Nのずれ</translation>
    </message>
    <message>
        <source>All points were touched</source>
        <translation>すべての点に触れました</translation>
    </message>
    <message>
        <source>%1 of %2 points touched; the ring marks a missed point</source>
        <translation>%2点中%1点に触れました。輪は触れなかった点を示します</translation>
    </message>
    <message>
        <source>Rubric &quot;%1&quot;, version %2, content %3. Undercuts and walls past 90° are not measured, because the model is a height field.</source>
        <extracomment>%1 is the name of a rubric, %2 its version, %3 the beginning of its hash</extracomment>
        <translation>評価基準「%1」、第%2版、内容%3。アンダーカットと90°を超える壁は測定されません：モデルは高さのデータです。</translation>
    </message>
    <message>
        <source>The tooth is measured again with half and with double the number of grid columns. The result is clear of the pass mark if all scores lie on the same side of it. This says nothing about another attempt.</source>
        <translation>歯を、格子の列数を半分と2倍にしてもう一度測定します。すべての得点が合格点の同じ側にあれば、結果は明確です。別の試行の結果については分かりません。</translation>
    </message>
    <message>
        <source>Lost points</source>
        <translation>失点の内訳</translation>
    </message>
    <message>
        <source>Finding the moment of each lost point …</source>
        <translation>失点した時点を調べています …</translation>
    </message>
    <message>
        <source>Finding the moment of each lost point</source>
        <translation>失点した時点を調べています</translation>
    </message>
    <message>
        <source>Grade</source>
        <translation>採点</translation>
    </message>
    <message>
        <source>Grade: %1</source>
        <extracomment>%1 is a lesson, &quot;Tooth 36&quot; or a file name %1 is a person, %2 a lesson</extracomment>
        <translation>成績：%1</translation>
    </message>
    <message>
        <source>Drilled with the hardness preset %1.</source>
        <extracomment>%1 is a hardness preset with its version</extracomment>
        <translation>硬さのプリセット%1で切削。</translation>
    </message>
    <message>
        <source>of 100</source>
        <translation>／100</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>Not passed: critical error</source>
        <translation>不合格：重大な誤り</translation>
    </message>
    <message>
        <source>Not passed yet</source>
        <translation>まだ合格ではありません</translation>
    </message>
    <message>
        <source>Score at half the grid: %1, at double the grid: %2.</source>
        <translation>格子が半分のときの得点：%1、2倍のとき：%2。</translation>
    </message>
    <message>
        <source>Score at half the grid: %1.</source>
        <translation>格子が半分のときの得点：%1。</translation>
    </message>
    <message>
        <source>Result is close to the pass mark.</source>
        <translation>結果は合格点に近い値です。</translation>
    </message>
    <message>
        <source>Result is clear of the pass mark.</source>
        <translation>結果は合格点から十分に離れています。</translation>
    </message>
    <message>
        <source>%1 has no place on the tooth</source>
        <translation>%1には歯の上の場所がありません</translation>
    </message>
    <message>
        <source>%1: no points lost</source>
        <extracomment>%1 a criterion of a score</extracomment>
        <translation>%1：減点なし</translation>
    </message>
    <message>
        <source>No deviation from the ideal</source>
        <translation>理想形からのずれはありません</translation>
    </message>
    <message>
        <source>%1 mm too deep</source>
        <translation>%1 mm深すぎます</translation>
    </message>
    <message>
        <source>%1 mm still to cut</source>
        <translation>残り%1 mm</translation>
    </message>
    <message>
        <source>%1: worst place</source>
        <extracomment>%1 a criterion of a score</extracomment>
        <translation>%1：最も悪い箇所</translation>
    </message>
    <message>
        <source>%1: worst place, %2</source>
        <translation>%1：最も悪い箇所、%2</translation>
    </message>
    <message>
        <source>%1 has no place on the tooth; largest deviation: %2</source>
        <translation>%1には歯の上の場所がありません。最大のずれ：%2</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Replay this attempt</source>
        <translation>この試行を再生します</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>報告書</translation>
    </message>
    <message>
        <source>Save or print the score card</source>
        <translation>成績表を保存または印刷します</translation>
    </message>
    <message>
        <source>Save as PDF …</source>
        <translation>PDFとして保存 …</translation>
    </message>
    <message>
        <source>Print …</source>
        <translation>印刷 …</translation>
    </message>
    <message>
        <source>Grade of %1: %2</source>
        <translation>%1さんの評価：%2</translation>
    </message>
    <message>
        <source>The student expected %1 points.</source>
        <translation>学生の予想：%1点</translation>
    </message>
    <message>
        <source>Passed (teacher&apos;s decision)</source>
        <translation>合格（教員の判断）</translation>
    </message>
    <message>
        <source>Not passed (teacher&apos;s decision)</source>
        <translation>不合格（教員の判断）</translation>
    </message>
    <message>
        <source>Automatic score: %1</source>
        <extracomment>%1: a sum of points</extracomment>
        <translation>自動採点：%1</translation>
    </message>
    <message>
        <source>This attempt has no readable recording. It cannot be replayed, and the tooth is not shown. The score and the lost points are shown as they were saved.</source>
        <translation>この試行には読み取れる記録がないため、再生できず、歯の画像も表示されません。点数と減点の内訳は保存されたときのままです。</translation>
    </message>
    <message>
        <source>Next time</source>
        <translation>次回は</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>How the points add up, and by which rules</source>
        <translation>得点の内訳と評価規則</translation>
    </message>
    <message>
        <source>Show it at %1</source>
        <extracomment>%1: minutes and seconds of the attempt</extracomment>
        <translation>%1の場面を見る</translation>
    </message>
    <message>
        <source>Next lesson</source>
        <translation>次のレッスン</translation>
    </message>
    <message>
        <source>Show the moment in the replay</source>
        <translation>再生でその場面を見る</translation>
    </message>
    <message>
        <source>Not passed: limited to %1</source>
        <extracomment>%1: points of a score</extracomment>
        <translation>不合格：最大%1点</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::SweepChart</name>
    <message>
        <source>Scores of past attempts over the tolerance</source>
        <translation>許容範囲に対する過去の試行の得点</translation>
    </message>
    <message>
        <source>At %1 times the tolerance %2 of %3 pass; median %4</source>
        <extracomment>%1: a number, &quot;1.5&quot;; %2 of %3 attempts; %4: points</extracomment>
        <translation>許容範囲%1倍で%3件中%2件が合格、中央値%4</translation>
    </message>
    <message>
        <source>Times the tolerance</source>
        <translation>許容範囲の倍率</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点数</translation>
    </message>
    <message>
        <source>Each attempt</source>
        <translation>各試行</translation>
    </message>
    <message>
        <source>%1: %2 points at %3 times the tolerance</source>
        <extracomment>%1: the name of a file, or which line</extracomment>
        <translation>%1：許容範囲%3倍で%2点</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>中央値</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>合格点</translation>
    </message>
    <message>
        <source>As set</source>
        <translation>設定値</translation>
    </message>
    <message>
        <source>Lower quartile</source>
        <translation>第1四分位数</translation>
    </message>
    <message>
        <source>Upper quartile</source>
        <translation>第3四分位数</translation>
    </message>
    <message>
        <source>Attempts that pass, %</source>
        <translation>合格する試行、%</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>記録</translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::SweepPage</name>
    <message>
        <source>Recordings …</source>
        <translation>記録 …</translation>
    </message>
    <message>
        <source>Choose the folder with recordings of attempts</source>
        <translation>試行の記録があるフォルダーを選びます</translation>
    </message>
    <message>
        <source>Choose the folder with recordings</source>
        <translation>記録のフォルダーを選ぶ</translation>
    </message>
    <message>
        <source>Whose tolerance is changed</source>
        <translation>変更する許容範囲</translation>
    </message>
    <message>
        <source>Recordings that are replayed</source>
        <translation>再生中の記録</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop replaying</source>
        <translation>再生を停止</translation>
    </message>
    <message>
        <source>Go on with those that are done</source>
        <translation>済んだものだけで続けます</translation>
    </message>
    <message>
        <source>All tolerances</source>
        <translation>すべての許容範囲</translation>
    </message>
    <message>
        <source>Choose a folder with recordings of this tooth: each is replayed once, and its score is drawn for tolerances from 0 to 3 times those at the left.</source>
        <translation>この歯の記録があるフォルダーを選んでください：それぞれを1回再生し、左の許容範囲の0～3倍での得点を描きます。</translation>
    </message>
    <message>
        <source>No attempt in this folder was made at this tooth.</source>
        <translation>このフォルダーには、この歯の試行がありません。</translation>
    </message>
    <message>
        <source>The attempts of the history were made for another ideal than this draft&apos;s. Choose a folder with recordings.</source>
        <translation>履歴の試行は、この下書きとは別の理想形で行われました。記録のフォルダーを選んでください。</translation>
    </message>
    <message numerus="yes">
        <source>%n of them from the history.</source>
        <translation>
            <numerusform>うち%n件は履歴からです。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) at other teeth are left out.</source>
        <translation>
            <numerusform>別の歯の試行%n件は除外しました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) could not be read.</source>
        <translation>
            <numerusform>%n件の記録を読み取れませんでした。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) of the history without measured values are left out.</source>
        <translation>
            <numerusform>測定値のない履歴の試行%n件は除外しました。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::lessoneditor::ToleranceView</name>
    <message>
        <source>The tolerances on the tooth</source>
        <translation>歯の上の許容範囲</translation>
    </message>
    <message>
        <source>Drag the line of the section; arrow keys move it, Shift with them turns it, as a double click does</source>
        <translation>断面の線をドラッグします。矢印キーで移動、Shiftと矢印またはダブルクリックで回転</translation>
    </message>
    <message>
        <source>Nothing to show yet: what is wrong is said at the left.</source>
        <translation>まだ表示できません：誤りは左に示されています。</translation>
    </message>
    <message>
        <source>The ideal is being made …</source>
        <translation>理想形を作成しています …</translation>
    </message>
</context>
<context>
    <name>ui::kit::FormInputs</name>
    <message>
        <source>%1 stays.</source>
        <translation>%1 のままです。</translation>
    </message>
    <message>
        <source>Only whole numbers from %1 to %2 can be entered here.</source>
        <extracomment>%1 and %2: the least and the greatest number, %2 with a unit</extracomment>
        <translation>ここに入力できるのは %1 ～ %2 の整数だけです。</translation>
    </message>
    <message>
        <source>Only %1 to %2 can be entered here.</source>
        <translation>ここに入力できるのは %1 ～ %2 だけです。</translation>
    </message>
</context>
<context>
    <name>ui::scoring::WorstSection</name>
    <message>
        <source>Section through the worst place</source>
        <translation>最も悪い箇所の断面</translation>
    </message>
</context>
<context>
    <name>ui::tooth::SceneWidget</name>
    <message>
        <source>No picture</source>
        <extracomment>Heading where a picture would be; a sentence below says why</extracomment>
        <translation>画像がありません</translation>
    </message>
</context>
<context>
    <name>ui::tooth::ToothView</name>
    <message>
        <source>This computer offers no OpenGL 3.3, so the tooth cannot be shown. Install or update the graphics driver (on Debian: libgl1-mesa-dri), then start Cusp again.</source>
        <translation>このコンピューターではOpenGL 3.3が使えないため、歯を表示できません。グラフィックドライバーをインストールまたは更新して（Debian：libgl1-mesa-dri）、Cuspを再起動してください。</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>歯</translation>
    </message>
    <message>
        <source>Arrow keys move the bur, page down pushes, page up lifts.</source>
        <translation>矢印キーでバーを動かし、Page Downで押し、Page Upで引き上げます。</translation>
    </message>
    <message>
        <source>%1 N</source>
        <extracomment>A force in newtons, beside the bur</extracomment>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 / %2 mm</source>
        <translation>%1 / %2 mm</translation>
    </message>
    <message>
        <source>Stop %1 mm</source>
        <extracomment>The depth at which the bur will stop</extracomment>
        <translation>ストップ %1 mm</translation>
    </message>
</context>
<context>
    <name>app::PedalController</name>
    <message>
        <source>The pedal was unplugged, and the bur was stopped. Plug it in again, or switch the drill on to work without it.</source>
        <translation>ペダルが外れたので、バーを止めました。もう一度接続するか、ドリルを入れてペダルなしで続けてください。</translation>
    </message>
    <message>
        <source>Show the device</source>
        <translation>機器を表示</translation>
    </message>
    <message>
        <source>The pedal is plugged in again.</source>
        <translation>ペダルが再び接続されました。</translation>
    </message>
</context>
<context>
    <name>ui::devices::AxisBars</name>
    <message>
        <source>Axes and buttons. No button is pressed.</source>
        <translation>軸とボタン。押されているボタンはありません。</translation>
    </message>
    <message>
        <source>Axes and buttons. Pressed: %1</source>
        <extracomment>%1: names of buttons</extracomment>
        <translation>軸とボタン。押されているもの: %1</translation>
    </message>
</context>
<context>
    <name>ui::devices::ControllerButtonsCard</name>
    <message>
        <source>Sticks, triggers and arrows</source>
        <extracomment>What sticks, triggers and arrows of a gamepad do</extracomment>
        <translation>スティック、トリガー、矢印</translation>
    </message>
    <message>
        <source>Press the button for: %1. Click again for none.</source>
        <extracomment>%1: &quot;Undo&quot;, or another action</extracomment>
        <translation>「%1」のボタンを押してください。もう一度クリックすると、なしになります。</translation>
    </message>
    <message>
        <source>Buttons. Click one here, then press it on the pedal or gamepad.</source>
        <translation>ボタン。ここで一つクリックしてから、ペダルかゲームパッドで押してください。</translation>
    </message>
    <message>
        <source>Press it …</source>
        <translation>押してください…</translation>
    </message>
    <message>
        <source>None</source>
        <extracomment>No button</extracomment>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1: an action; %2: a button</extracomment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>ui::devices::Controllers</name>
    <message>
        <source>Not part of this program.</source>
        <translation>このプログラムには含まれていません。</translation>
    </message>
    <message>
        <source>Pedals and gamepads cannot be read.</source>
        <translation>ペダルとゲームパッドを読み取れません。</translation>
    </message>
    <message>
        <source>The pedal is ready.</source>
        <translation>ペダルは使えます。</translation>
    </message>
    <message>
        <source>The chosen pedal is not plugged in.</source>
        <translation>選んだペダルが接続されていません。</translation>
    </message>
    <message>
        <source>The pedal is pressed, or it sticks. Release it.</source>
        <translation>ペダルが踏まれているか、引っかかっています。離してください。</translation>
    </message>
    <message>
        <source>Nothing is plugged in.</source>
        <translation>何も接続されていません。</translation>
    </message>
    <message>
        <source>This program was built without SDL 2. The mouse and the keyboard work without it.</source>
        <translation>このプログラムは SDL 2 なしで作られました。マウスとキーボードはそのまま使えます。</translation>
    </message>
    <message>
        <source>The bur turns while the pedal is pressed, and faster the farther it is pressed.</source>
        <translation>ペダルを踏んでいる間だけバーが回り、深く踏むほど速くなります。</translation>
    </message>
    <message>
        <source>Plug in &quot;%1&quot;. Until then, the bur runs without a pedal.</source>
        <extracomment>%1: name of a pedal</extracomment>
        <translation>「%1」を接続してください。それまでバーはペダルなしで動きます。</translation>
    </message>
    <message>
        <source>The bur does not start before the pedal has been seen released. If it is released now, teach it again.</source>
        <translation>ペダルが一度離されるまでバーは動きません。今離しているなら、もう一度覚えさせてください。</translation>
    </message>
    <message>
        <source>Plug in a foot pedal or a gamepad. A pedal that acts as a keyboard needs nothing here: let it send Page Down.</source>
        <translation>フットペダルかゲームパッドを接続してください。キーボードとして働くペダルには設定は要りません。ページダウンのキーを送るようにしてください。</translation>
    </message>
    <message>
        <source>Run the bur</source>
        <extracomment>What a button does: the bur turns at full speed while it is pressed</extracomment>
        <translation>バーを回す</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>ミラー</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>中央</translation>
    </message>
    <message>
        <source>Next view</source>
        <extracomment>What a button does: looks at the tooth from another side</extracomment>
        <translation>次の視点</translation>
    </message>
    <message>
        <source>Next bur</source>
        <translation>次のバー</translation>
    </message>
    <message>
        <source>Finish and grade</source>
        <translation>終えて採点</translation>
    </message>
    <message>
        <source>Left stick, sideways</source>
        <translation>左スティック、左右</translation>
    </message>
    <message>
        <source>Left stick, up and down</source>
        <translation>左スティック、上下</translation>
    </message>
    <message>
        <source>Right stick, sideways</source>
        <translation>右スティック、左右</translation>
    </message>
    <message>
        <source>Right stick, up and down</source>
        <translation>右スティック、上下</translation>
    </message>
    <message>
        <source>Left trigger</source>
        <translation>左トリガー</translation>
    </message>
    <message>
        <source>Right trigger</source>
        <translation>右トリガー</translation>
    </message>
    <message>
        <source>Axis %1</source>
        <extracomment>Of a pedal; %1: a number</extracomment>
        <translation>軸 %1</translation>
    </message>
    <message>
        <source>View</source>
        <extracomment>A button of a gamepad</extracomment>
        <translation>表示</translation>
    </message>
    <message>
        <source>Guide</source>
        <extracomment>A button of a gamepad</extracomment>
        <translation>ガイド</translation>
    </message>
    <message>
        <source>Menu</source>
        <extracomment>A button of a gamepad</extracomment>
        <translation>メニュー</translation>
    </message>
    <message>
        <source>Left stick</source>
        <extracomment>The button in a stick of a gamepad</extracomment>
        <translation>左スティック</translation>
    </message>
    <message>
        <source>Right stick</source>
        <extracomment>The button in a stick of a gamepad</extracomment>
        <translation>右スティック</translation>
    </message>
    <message>
        <source>Moves the bur over the tooth</source>
        <translation>バーを歯の上で動かす</translation>
    </message>
    <message>
        <source>Turns the view</source>
        <translation>視点を回す</translation>
    </message>
    <message>
        <source>Presses the bur down: the farther, the harder</source>
        <translation>バーを押し付ける。深く引くほど強くなる</translation>
    </message>
    <message>
        <source>Sets the speed of the bur, if it is the pedal</source>
        <translation>ペダルとして選んだとき、バーの速さを決める</translation>
    </message>
    <message>
        <source>Arrows</source>
        <extracomment>The cross of four arrows on a gamepad</extracomment>
        <translation>矢印</translation>
    </message>
    <message>
        <source>Go through the buttons of the panel, or of the page</source>
        <translation>パネルやページのボタンを移動する</translation>
    </message>
    <message>
        <source>Presses the button that the arrows have gone to</source>
        <translation>矢印で選んだボタンを押す</translation>
    </message>
    <message>
        <source>Leads back to the tooth</source>
        <translation>歯に戻る</translation>
    </message>
    <message>
        <source>Plugged in: %1</source>
        <extracomment>%1: names of pedals and gamepads</extracomment>
        <translation>接続中: %1</translation>
    </message>
    <message>
        <source>Teach a pedal by one press: its travel then sets the speed of the bur. A gamepad works as it comes.</source>
        <translation>ペダルを一度踏んで覚えさせると、踏み込みでバーの速さが決まります。ゲームパッドはそのまま使えます。</translation>
    </message>
    <message>
        <source>LB</source>
        <extracomment>Left shoulder button of a gamepad, as it is printed on it</extracomment>
        <translation>LB</translation>
    </message>
    <message>
        <source>RB</source>
        <extracomment>Right shoulder button of a gamepad, as it is printed on it</extracomment>
        <translation>RB</translation>
    </message>
</context>
<context>
    <name>ui::devices::PedalCard</name>
    <message>
        <source>Pedal or gamepad</source>
        <translation>ペダルまたはゲームパッド</translation>
    </message>
    <message>
        <source>The bur turns only while this pedal is pressed</source>
        <translation>このペダルを踏んでいる間だけバーを回す</translation>
    </message>
    <message>
        <source>Another one of the same kind is plugged in too. The one that was plugged in first counts.</source>
        <translation>同じ種類のものがもう一つ接続されています。先に接続したものが使われます。</translation>
    </message>
    <message>
        <source>Work without this pedal</source>
        <translation>このペダルを使わずに作業</translation>
    </message>
</context>
<context>
    <name>ui::devices::PedalSetupCard</name>
    <message>
        <source>Inverted</source>
        <extracomment>Of a pedal: the bur runs while it is released</extracomment>
        <translation>反転</translation>
    </message>
    <message>
        <source>Dead zone</source>
        <extracomment>Of a pedal: the part of its travel in which the bur stands</extracomment>
        <translation>不感帯</translation>
    </message>
    <message>
        <source>Curve</source>
        <extracomment>Of a pedal: 1 is a straight line</extracomment>
        <translation>カーブ</translation>
    </message>
    <message>
        <source>1 is a straight line. With more, slow speeds have more of the travel.</source>
        <translation>1 は直線です。大きくすると、遅い速さの範囲が広くなります。</translation>
    </message>
    <message>
        <source>Press the pedal fully and release it.</source>
        <translation>ペダルをいっぱいに踏んで離してください。</translation>
    </message>
    <message>
        <source>No pedal has been taught. The speed of the bur follows its travel once it has.</source>
        <translation>まだペダルを覚えさせていません。覚えさせると、バーの速さが踏み込みに従います。</translation>
    </message>
    <message>
        <source>The speed of the bur follows: %1.</source>
        <extracomment>%1: &quot;Left trigger&quot; or &quot;Axis 1&quot;</extracomment>
        <translation>バーの速さを決めるもの: %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Teach the pedal</source>
        <translation>ペダルを覚えさせる</translation>
    </message>
    <message>
        <source>Speed of the bur over the travel of the pedal</source>
        <translation>ペダルの踏み込みに対するバーの速さ</translation>
    </message>
</context>
<context>
    <name>ui::devices::SoundCard</name>
    <message>
        <source>Play sound</source>
        <translation>音を鳴らす</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>音量</translation>
    </message>
    <message>
        <source>Handpiece</source>
        <extracomment>Volume of a part of the sound</extracomment>
        <translation>ハンドピース</translation>
    </message>
    <message>
        <source>Cutting</source>
        <extracomment>Volume of a part of the sound</extracomment>
        <translation>切削</translation>
    </message>
    <message>
        <source>Contact</source>
        <extracomment>Volume of a part of the sound: the bur meets the tooth</extracomment>
        <translation>接触</translation>
    </message>
    <message>
        <source>Spray</source>
        <extracomment>Volume of a part of the sound: water that cools the bur</extracomment>
        <translation>スプレー</translation>
    </message>
    <message>
        <source>Suction</source>
        <extracomment>Volume of a part of the sound</extracomment>
        <translation>吸引</translation>
    </message>
    <message>
        <source>Volume: %1</source>
        <extracomment>Name of a slider; %1: &quot;Handpiece&quot;, &quot;Cutting&quot;</extracomment>
        <translation>音量：%1</translation>
    </message>
    <message>
        <source>Output</source>
        <extracomment>Of sound: loudspeakers or headphones</extracomment>
        <translation>出力</translation>
    </message>
    <message>
        <source>Play a sample</source>
        <translation>試聴</translation>
    </message>
    <message>
        <source>The turbine runs free, cuts enamel, then dentin</source>
        <translation>タービンが空転し、エナメル質、次に象牙質を切削します</translation>
    </message>
    <message>
        <source>As the system is set</source>
        <extracomment>Audio output</extracomment>
        <translation>システムの設定に従う</translation>
    </message>
    <message>
        <source>The chosen output (missing)</source>
        <extracomment>Audio output that was chosen before and is not plugged in</extracomment>
        <translation>選んだ出力（接続なし）</translation>
    </message>
</context>
<context>
    <name>ui::devices::SoundText</name>
    <message>
        <source>Off.</source>
        <extracomment>Of sound</extracomment>
        <translation>オフ。</translation>
    </message>
    <message>
        <source>Silent: this computer has no audio output.</source>
        <translation>無音：このコンピューターには音声出力がありません。</translation>
    </message>
    <message>
        <source>Silent: %1 does not play.</source>
        <extracomment>%1: an audio output, as the system calls it</extracomment>
        <translation>無音：%1 で再生できません。</translation>
    </message>
    <message>
        <source>The chosen output is missing; %1 plays instead.</source>
        <extracomment>%1: an audio output, as the system calls it</extracomment>
        <translation>選んだ出力がありません。代わりに %1 で再生します。</translation>
    </message>
    <message>
        <source>Plays on %1.</source>
        <extracomment>%1: an audio output, as the system calls it</extracomment>
        <translation>%1 で再生します。</translation>
    </message>
    <message>
        <source>Plug in headphones or loudspeakers: the sound then starts without a restart. Everything else works without sound.</source>
        <translation>ヘッドホンかスピーカーを接続すると、再起動せずに音が出ます。ほかの機能は音がなくても使えます。</translation>
    </message>
    <message>
        <source>Choose another output, or close the program that uses this one. Cusp tries again every second.</source>
        <translation>別の出力を選ぶか、この出力を使っているプログラムを閉じてください。Cusp は毎秒再試行します。</translation>
    </message>
    <message>
        <source>Plug the output in again: the sound then returns to it.</source>
        <translation>出力を再び接続すると、音はそこに戻ります。</translation>
    </message>
    <message>
        <source>The handpiece drops in pitch under load. Enamel sounds bright, dentin dull. The sound plays while you see the tooth.</source>
        <translation>負荷がかかるとハンドピースの音が低くなります。エナメル質は明るく、象牙質は鈍く響きます。音は歯が表示されている間だけ鳴ります。</translation>
    </message>
</context>
<context>
    <name>ui::practice::BurPicker</name>
    <message>
        <source>Round</source>
        <translation>ラウンド</translation>
    </message>
    <message>
        <source>Inverted cone</source>
        <translation>インバーテッドコーン</translation>
    </message>
    <message>
        <source>Straight fissure</source>
        <translation>ストレートフィッシャー</translation>
    </message>
    <message>
        <source>Tapered fissure</source>
        <translation>テーパーフィッシャー</translation>
    </message>
    <message>
        <source>Pear, egg and flame</source>
        <translation>ペアー、エッグ、フレーム</translation>
    </message>
    <message>
        <source>Diamonds</source>
        <translation>ダイヤモンド</translation>
    </message>
    <message>
        <source>All burs</source>
        <translation>すべてのバー</translation>
    </message>
    <message>
        <source>Search by number, ISO size or shape</source>
        <translation>番号、ISOサイズ、形で検索</translation>
    </message>
    <message>
        <source>There is no such bur.</source>
        <translation>該当するバーはありません。</translation>
    </message>
    <message>
        <source>Take it out of the panel</source>
        <translation>パネルから外します</translation>
    </message>
    <message>
        <source>The panel holds four burs: take one out first.</source>
        <translation>パネルに置けるバーは4本までです。先に1本外してください。</translation>
    </message>
    <message>
        <source>Keep it at hand in the panel</source>
        <translation>パネルに置きます</translation>
    </message>
    <message>
        <source>Keep at hand: %1</source>
        <extracomment>%1: a bur such as &quot;Pear, No. 330&quot;</extracomment>
        <translation>パネルに置く：%1</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <extracomment>Diameter and length of a bur</extracomment>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>ISO %1</source>
        <extracomment>Size of a bur as in ISO 6360</extracomment>
        <translation>ISO %1</translation>
    </message>
    <message>
        <source>Grit %1</source>
        <extracomment>Of a diamond bur: number of its grit in ISO 6360, such as 524</extracomment>
        <translation>粒度 %1</translation>
    </message>
    <message>
        <source>This lesson does not allow it.</source>
        <translation>この課題では使えません。</translation>
    </message>
</context>
<context>
    <name>ui::devices::PenField</name>
    <message>
        <source>Press the pen here</source>
        <extracomment>In a field in which the user tries the pen of a graphics tablet</extracomment>
        <translation>ここをペンで押してください</translation>
    </message>
</context>
<context>
    <name>ui::devices::PenCard</name>
    <message>
        <source>Pen</source>
        <translation>ペン</translation>
    </message>
    <message>
        <source>The tilt of the pen is ignored: the bur stays upright.</source>
        <translation>ペンの傾きは無視されます。バーは常にまっすぐ立っています。</translation>
    </message>
    <message>
        <source>Curve</source>
        <extracomment>Of a pen: 1 is a straight line</extracomment>
        <translation>カーブ</translation>
    </message>
    <message>
        <source>1 is a straight line. With more, a light touch presses more weakly.</source>
        <translation>1 は直線です。大きくすると、軽いタッチの力がより弱くなります。</translation>
    </message>
    <message>
        <source>Force over the pressure of the pen</source>
        <translation>ペンの筆圧に対する力</translation>
    </message>
    <message>
        <source>No pen has been seen yet. Press it in the field, or move it over the field.</source>
        <translation>まだペンが検出されていません。枠の中をペンで押すか、その上で動かしてください。</translation>
    </message>
    <message>
        <source>That was a mouse, or a pen whose driver reports no pressure. The bur presses with %1 N.</source>
        <extracomment>%1: newtons</extracomment>
        <translation>マウス、または筆圧を送らないドライバーのペンによる操作でした。バーは %1 N で押します。</translation>
    </message>
    <message>
        <source>The pen hovers: the bur follows it and does not press.</source>
        <translation>ペンが浮いています。バーはペンに追従し、押しません。</translation>
    </message>
    <message>
        <source>Pressure %1 %: the bur presses with %2 N of %3 N.</source>
        <extracomment>%1: per cent; %2 and %3: newtons</extracomment>
        <translation>筆圧 %1 %：バーは %3 N のうち %2 N で押します。</translation>
    </message>
</context>
<context>
    <name>ui::devices::HandGuidePicture</name>
    <message>
        <source>50 to 70 cm</source>
        <extracomment>Between the eyes and the screen</extracomment>
        <translation>50～70 cm</translation>
    </message>
</context>
<context>
    <name>ui::devices::StillnessTest</name>
    <message>
        <source>Time that is over</source>
        <translation>経過時間</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Once more</source>
        <translation>もう一度</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Get ready.</source>
        <translation>準備してください。</translation>
    </message>
    <message>
        <source>Hold still.</source>
        <translation>動かさないでください。</translation>
    </message>
    <message>
        <source>This can be tried when the device is ready.</source>
        <translation>装置の準備ができると試せます。</translation>
    </message>
    <message>
        <source>The device stopped responding. Start again when it is ready.</source>
        <translation>装置が応答しなくなりました。準備ができたら、もう一度開始してください。</translation>
    </message>
    <message>
        <source>Too few positions were measured. Close other programs and start again.</source>
        <translation>測定できた位置が少なすぎます。ほかのプログラムを閉じて、もう一度開始してください。</translation>
    </message>
    <message>
        <source>On the tooth, the bur drifted by %1 mm and trembled by %2 mm.</source>
        <extracomment>%1 and %2: millimetres</extracomment>
        <translation>歯の上で、バーは %1 mm ずれ、%2 mm 震えました。</translation>
    </message>
    <message>
        <source>On the screen, the pointer drifted by %1 mm and trembled by %2 mm.</source>
        <translation>画面上で、ポインターは %1 mm ずれ、%2 mm 震えました。</translation>
    </message>
    <message>
        <source>The hand drifts: support the forearm, and try another height of the rest.</source>
        <translation>手がずれています。前腕を支え、支えの高さを変えてみてください。</translation>
    </message>
    <message>
        <source>The hand trembles: hold the grip loosely, put a finger on the rest, or choose a larger scale on the next step.</source>
        <translation>手が震えています。グリップを軽く持ち、指を支えに置くか、次のステップで倍率を大きくしてください。</translation>
    </message>
    <message>
        <source>The hand trembles: put the wrist on the table, or zoom in at the tooth.</source>
        <translation>手が震えています。手首を机に置くか、歯を拡大表示してください。</translation>
    </message>
    <message>
        <source>That is steady.</source>
        <translation>安定しています。</translation>
    </message>
</context>
<context>
    <name>ui::devices::HandGuide</name>
    <message>
        <source>Scale</source>
        <extracomment>How far the hand moves for one millimetre of the bur</extracomment>
        <translation>倍率</translation>
    </message>
    <message>
        <source>Movement of the hand for 1 mm of the bur, in millimetres. With more, drift and tremor of the hand move the bur less.</source>
        <translation>バーが 1 mm 動くときの手の動き（ミリメートル）。大きくすると、手のずれや震えによるバーの動きが小さくなります。</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <extracomment>%1 and %2: numbers</extracomment>
        <translation>ステップ %1 / %2</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>右手</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>左手</translation>
    </message>
    <message>
        <source>Use this height</source>
        <extracomment>The height at which the hand is now</extracomment>
        <translation>この高さを使う</translation>
    </message>
    <message>
        <source>Use the middle</source>
        <translation>中央を使う</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>次へ</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Which hand do you work with?</source>
        <translation>どちらの手で作業しますか？</translation>
    </message>
    <message>
        <source>Place the screen</source>
        <translation>画面の位置</translation>
    </message>
    <message>
        <source>Rest the hand</source>
        <translation>手を支える</translation>
    </message>
    <message>
        <source>Hold still</source>
        <translation>手を動かさない</translation>
    </message>
    <message>
        <source>Your place</source>
        <translation>作業場所</translation>
    </message>
    <message>
        <source>The handpiece comes from the side of this hand, and the light from the other one. Place the mouse, the tablet or the device on this side.</source>
        <translation>ハンドピースはこの手の側から、光は反対側から来ます。マウス、ペンタブレット、装置はこの側に置いてください。</translation>
    </message>
    <message>
        <source>Place it straight in front of you, 50 to 70 cm from your eyes. Its upper edge is at the height of your eyes or a little below. Sit upright and let the shoulders hang.</source>
        <translation>画面は正面に、目から 50～70 cm 離して置きます。上端は目の高さか、少し下にします。背筋を伸ばして座り、肩の力を抜いてください。</translation>
    </message>
    <message>
        <source>Put a box or a firm cushion in front of the device, so that the ring finger rests while you hold the grip, as it does on a tooth. Hold the grip as if at the tooth. The top of the tooth comes to the height that you store.</source>
        <translation>装置の前に箱か固いクッションを置き、グリップを持つときに、歯の上と同じように薬指を支えられるようにします。歯を削るときのようにグリップを持ってください。保存した高さが歯の上面の高さになります。</translation>
    </message>
    <message>
        <source>Lay the forearm on the table, with the wrist straight. Hold a pen near its tip, and rest the little finger beside it. Move a mouse with the fingers.</source>
        <translation>手首をまっすぐにして前腕を机に置きます。ペンは先端の近くを持ち、そばに小指を置いて支えます。マウスは指で動かします。</translation>
    </message>
    <message>
        <source>Hold the grip as if at the tooth, with a finger on the rest. Press Start with the other hand and hold still for 8 seconds.</source>
        <translation>指を支えに置き、歯を削るときのようにグリップを持ちます。もう一方の手で「開始」を押し、8 秒間動かさないでください。</translation>
    </message>
    <message>
        <source>Press Start with the space bar, or click it and leave the pointer there. Hold still for 8 seconds. A pen hovers meanwhile.</source>
        <translation>スペースキーで「開始」を押すか、クリックしてポインターをそのままにします。8 秒間動かさないでください。ペンの場合は浮かせたままにします。</translation>
    </message>
    <message>
        <source>Not all of the tooth could be reached from %1 mm, so %2 mm is stored. Move the rest or the device instead.</source>
        <extracomment>%1 and %2: millimetres</extracomment>
        <translation>%1 mm では歯全体に届かないため、%2 mm を保存しました。代わりに支えか装置を動かしてください。</translation>
    </message>
    <message>
        <source>The top of the tooth is at the middle of the work area.</source>
        <translation>歯の上面は作業範囲の中央にあります。</translation>
    </message>
    <message>
        <source>The top of the tooth is %1 mm above the middle of the work area.</source>
        <extracomment>%1: millimetres</extracomment>
        <translation>歯の上面は作業範囲の中央より %1 mm 上にあります。</translation>
    </message>
    <message>
        <source>The top of the tooth is %1 mm below the middle of the work area.</source>
        <extracomment>%1: millimetres</extracomment>
        <translation>歯の上面は作業範囲の中央より %1 mm 下にあります。</translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <extracomment>%1: &quot;Right hand&quot;; %2: &quot;Novint Falcon&quot;</extracomment>
        <translation>%1、%2。</translation>
    </message>
    <message>
        <source>How still the hand is held was not measured.</source>
        <translation>手の安定は測定されていません。</translation>
    </message>
    <message>
        <source>The device is not ready. Its entry on the page of devices says what to do.</source>
        <translation>装置の準備ができていません。装置ページのその項目に、すべきことが示されています。</translation>
    </message>
    <message>
        <source>The grip is %1 mm above the middle of the work area.</source>
        <extracomment>%1: millimetres</extracomment>
        <translation>グリップは作業範囲の中央より %1 mm 上にあります。</translation>
    </message>
    <message>
        <source>The grip is %1 mm below the middle of the work area.</source>
        <extracomment>%1: millimetres</extracomment>
        <translation>グリップは作業範囲の中央より %1 mm 下にあります。</translation>
    </message>
    <message>
        <source>Mouse or pen</source>
        <translation>マウスまたはペン</translation>
    </message>
</context>
<context>
    <name>app::SoundController</name>
    <message>
        <source>Show the device</source>
        <translation>デバイスを表示</translation>
    </message>
    <message>
        <source>The sound is on.</source>
        <translation>音はオンです。</translation>
    </message>
    <message>
        <source>The sound is off. %1 turns it on again.</source>
        <extracomment>%1: a key</extracomment>
        <translation>音はオフです。%1 で再びオンにします。</translation>
    </message>
</context>
</TS>
