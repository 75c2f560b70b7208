<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja">
<context>
    <name>App::Property</name>
    <message>
        <source>Distance of neighbouring dimples; 0: from the other sizes</source>
        <translation>隣り合うディンプルの距離。0: 他の寸法から</translation>
    </message>
    <message>
        <source>Overlapping: the dimples&apos; bottoms are the faces; isolated: the faces stay between dimples</source>
        <translation>重なり: くぼみの底が面になる; 独立: くぼみの間に面が残る</translation>
    </message>
    <message>
        <source>Depth of the dimples; 0: from the other sizes</source>
        <translation>ディンプルの深さ。0: 他の寸法から</translation>
    </message>
    <message>
        <source>Diameter of a dimple&apos;s rim; 0: from the other sizes</source>
        <translation>ディンプルの縁の直径。0: 他の寸法から</translation>
    </message>
    <message>
        <source>Share of the faces that isolated dimples take up, 0 to 1; 0: from the other sizes</source>
        <translation>独立したくぼみが占める面の割合、0〜1; 0: 他の寸法から</translation>
    </message>
    <message>
        <source>Height of what stays between neighbouring dimples; 0: from the other sizes</source>
        <translation>隣り合うくぼみの間に残る高さ; 0: 他の寸法から</translation>
    </message>
    <message>
        <source>Projected: spacing kept as seen along the projection; on surface: kept along the faces</source>
        <translation>投影: 投影方向から見て間隔を保つ; 面上: 面に沿って間隔を保つ</translation>
    </message>
    <message>
        <source>Shape of the patches: squares and rectangles on a square lattice, the others on a triangular one</source>
        <translation>パッチの形: 正方形と長方形は正方格子、他は三角格子</translation>
    </message>
    <message>
        <source>Dimples along the side of a square or triangle; radius of a hexagon in dimples</source>
        <translation>正方形や三角形の一辺のくぼみの数; 六角形ではくぼみで数えた半径</translation>
    </message>
    <message>
        <source>Dimples along the other side of a patch whose sides may differ; 0: as the first side</source>
        <translation>辺の長さが異なりうるパッチのもう一辺のくぼみの数; 0: 最初の辺と同じ</translation>
    </message>
    <message>
        <source>Patches along X; 0 covers the faces</source>
        <translation>X方向のパッチの数; 0: 面を覆う</translation>
    </message>
    <message>
        <source>Patches along Y; 0 covers the faces</source>
        <translation>Y方向のパッチの数; 0: 面を覆う</translation>
    </message>
    <message>
        <source>Mill each patch from its outline inwards, or from its centre outwards</source>
        <translation>各パッチを外周から内へ、または中心から外へ削る</translation>
    </message>
    <message>
        <source>Begin all patches at the same corner, or at the corner nearest to the patch before</source>
        <translation>すべてのパッチを同じ角から、または前のパッチに最も近い角から始める</translation>
    </message>
    <message>
        <source>Mill patch by patch along helices, or in rows of the lattice</source>
        <translation>パッチごとにらせん状に、または格子の行ごとに加工</translation>
    </message>
    <message>
        <source>Rows run over the whole face, across the borders of patches, or inside each patch</source>
        <translation>列をパッチの境を越えて面全体に通す、または各パッチの中に収める</translation>
    </message>
    <message>
        <source>Direction of the lattice that rows go along: the one of the least time (each is planned), the one nearest to the texture&apos;s X or Y, or the one along which the faces bend least</source>
        <translation>列が従う格子の方向: 時間が最も短い方向 (それぞれ計画する)、テクスチャのXまたはYに最も近い方向、または面の曲がりが最も小さい方向</translation>
    </message>
    <message>
        <source>Mill all rows in the same sense; otherwise to and fro</source>
        <translation>すべての列を同じ向きに削る; それ以外は往復</translation>
    </message>
    <message>
        <source>Number of the patch, in milling order, with which the program begins; 1: all are milled</source>
        <translation>プログラムを始めるパッチの加工順の番号; 1: すべて削る</translation>
    </message>
    <message>
        <source>Begin each patch with a comment that has its number</source>
        <translation>各パッチの初めに番号のコメントを置く</translation>
    </message>
    <message>
        <source>Direction in which the texture is projected on the faces</source>
        <translation>テクスチャを面に投影する方向</translation>
    </message>
    <message>
        <source>Project on the faces from the side on which they look largest</source>
        <translation>面が最も大きく見える側から投影する</translation>
    </message>
    <message>
        <source>Rotation of the texture</source>
        <translation>テクスチャの回転</translation>
    </message>
    <message>
        <source>Centre the texture on the faces</source>
        <translation>テクスチャを面の中央に置く</translation>
    </message>
    <message>
        <source>Centre of the texture, if not automatic</source>
        <translation>テクスチャの中心 (自動でない場合)</translation>
    </message>
    <message>
        <source>Dimples where the face is steeper than this to the projection are left out</source>
        <translation>面が投影に対してこれより急な所のくぼみを除く</translation>
    </message>
    <message>
        <source>Dimples where the tool axis is nearer to the normal than this are left out: the tip rubs</source>
        <translation>工具軸がこれより法線に近い所のくぼみを除く: 先端がこする</translation>
    </message>
    <message>
        <source>Leave out dimples in which the tip of the ball, which does not cut, would rub</source>
        <translation>切れないボール先端がこするくぼみを除く</translation>
    </message>
    <message>
        <source>Dimples nearer than this to the border of the faces are left out</source>
        <translation>面の境界にこれより近いディンプルは除外されます</translation>
    </message>
    <message>
        <source>Patches with fewer dimples than this on the faces are left out</source>
        <translation>面上のくぼみがこれより少ないパッチを除く</translation>
    </message>
    <message>
        <source>What a picture or closed curves do: leave dimples out, thin them, or set their depth</source>
        <translation>画像や閉曲線の働き: ディンプルの除外、間引き、または深さの設定</translation>
    </message>
    <message>
        <source>Picture: white is milled, black is not</source>
        <translation>画像: 白は削り、黒は削らない</translation>
    </message>
    <message>
        <source>Sketches or wires: inside is milled, outside is not; used if there is no picture</source>
        <translation>スケッチまたはワイヤー: 内側は削り、外側は削らない; 画像がない場合に使う</translation>
    </message>
    <message>
        <source>Change black for white, inside for outside</source>
        <translation>黒と白、内と外を入れ替える</translation>
    </message>
    <message>
        <source>Width of the picture on the texture plane; 0: as large as fits the faces</source>
        <translation>テクスチャ平面上の画像の幅; 0: 面に収まる大きさ</translation>
    </message>
    <message>
        <source>Centre of the picture from the texture&apos;s own, along its X and Y</source>
        <translation>テクスチャの中心から見た画像の中心 (テクスチャのXとYに沿って)</translation>
    </message>
    <message>
        <source>Grey below which dimples are left out, 0 (black) to 1 (white)</source>
        <translation>これより暗い所のくぼみを除く灰色、0 (黒) 〜 1 (白)</translation>
    </message>
    <message>
        <source>Depth of dimples where it is black</source>
        <translation>黒い所のくぼみの深さ</translation>
    </message>
    <message>
        <source>Depth of dimples where it is white</source>
        <translation>白い所のくぼみの深さ</translation>
    </message>
    <message>
        <source>How the spindle&apos;s phase is kept</source>
        <translation>主軸位相の保ち方</translation>
    </message>
    <message>
        <source>Name of the machine file; empty: unknown</source>
        <translation>機械ファイルの名前。空欄: 不明</translation>
    </message>
    <message>
        <source>Post even if the machine cannot hold the phase</source>
        <translation>機械が位相を保てなくても出力する</translation>
    </message>
    <message>
        <source>Ball and flutes may cut so deep below the model, besides the texture itself</source>
        <translation>ボールと刃がモデルの下へ切り込んでよい深さ (テクスチャ自体を除く)</translation>
    </message>
    <message>
        <source>Shank and holder must keep so far away from the model</source>
        <translation>シャンクとホルダーがモデルから離れるべき距離</translation>
    </message>
    <message>
        <source>How far the tool stands out of its holder; 0: the tool bit&apos;s length</source>
        <translation>工具がホルダーから出る長さ; 0: 工具の長さ</translation>
    </message>
    <message>
        <source>Diameter of the holder, for the collision check; 0: no holder</source>
        <translation>衝突検査用のホルダーの直径; 0: ホルダーなし</translation>
    </message>
    <message>
        <source>Length of the holder, for the collision check</source>
        <translation>衝突検査用のホルダーの長さ</translation>
    </message>
    <message>
        <source>Post even if the tool gouges or collides, or if that is not known</source>
        <translation>工具が食い込むか衝突する場合や、それが不明な場合も出力する</translation>
    </message>
    <message>
        <source>Fixed axis, surface normal with lead and tilt, fixed axis but leaned away from the normal, or field</source>
        <translation>固定軸、リード角と傾き付きの面法線、法線から離した固定軸、または場</translation>
    </message>
    <message>
        <source>Direction from the tip to the holder; other than Z it needs rotary axes</source>
        <translation>先端からホルダーへの方向; Z以外では回転軸が必要</translation>
    </message>
    <message>
        <source>Lean from the normal towards the feed</source>
        <translation>法線から送り方向への傾き</translation>
    </message>
    <message>
        <source>Lean from the normal to the left of the feed</source>
        <translation>法線から送りの左への傾き</translation>
    </message>
    <message>
        <source>Least angle between tool axis and normal, so that the tip does not cut</source>
        <translation>先端で切らないための工具軸と法線の最小角</translation>
    </message>
    <message>
        <source>Direction that the lead leans towards instead of the feed; zero: the feed</source>
        <translation>送りの代わりに傾ける方向; ゼロ: 送り方向</translation>
    </message>
    <message>
        <source>DCM modifier whose voxel model gives the axes; none: the job&apos;s stock less its model</source>
        <translation>軸を与えるボクセルモデルのDCM修飾; なし: ジョブの素材からモデルを引いたもの</translation>
    </message>
    <message>
        <source>Side of a voxel if no modifier is named</source>
        <translation>修飾を指定しない場合のボクセルの一辺</translation>
    </message>
    <message>
        <source>By how much an axis may be drawn towards its neighbours&apos;</source>
        <translation>軸を隣の軸へ寄せてよい角度</translation>
    </message>
    <message>
        <source>Greatest angle of the axis to Z</source>
        <translation>軸とZの最大角</translation>
    </message>
    <message>
        <source>Spindle-locked rows keep one axis; greatest angle between it and the one asked for (half of it is used to turn less from row to row)</source>
        <translation>スピンドル同期の列は一つの軸を保つ; その軸と求める軸の最大角 (半分は列ごとの回転を減らすために使う)</translation>
    </message>
    <message>
        <source>Whether the controller keeps the tool point (TCP), or the program is referred to the pivots</source>
        <translation>制御装置が工具先端点を保つ (TCP) か、プログラムを回転中心基準とするか</translation>
    </message>
    <message>
        <source>Length from the spindle&apos;s gauge point to the tip, for tilting heads without TCP</source>
        <translation>TCPのない旋回ヘッドでの、スピンドル基準点から先端までの長さ</translation>
    </message>
    <message>
        <source>Clearance of paced paths between rows</source>
        <translation>送り同期の経路の列間の逃げ</translation>
    </message>
    <message>
        <source>One flute makes all dimples</source>
        <translation>1 枚の刃ですべてのディンプルを作る</translation>
    </message>
    <message>
        <source>Spindle turns added between dimples</source>
        <translation>ディンプル間に加える主軸回転</translation>
    </message>
    <message>
        <source>Angle added per dimple, for calibration</source>
        <translation>校正のためくぼみごとに加える角度</translation>
    </message>
    <message>
        <source>Decimals of the posted coordinates; must be the post&apos;s own</source>
        <translation>出力座標の小数桁; ポストと同じであること</translation>
    </message>
    <message>
        <source>Greatest phase error of the posted program</source>
        <translation>出力プログラムの最大位相誤差</translation>
    </message>
    <message>
        <source>Each patch&apos;s plane fits its dimples on the faces best, or goes through its corners there</source>
        <translation>各パッチの平面を面上のくぼみに最もよく合わせる、または面上の角を通す</translation>
    </message>
    <message>
        <source>Lattice: dimples are placed; free: marks fall as side, cross-feed and feed make them</source>
        <translation>格子: くぼみを配置する; 自由: 一辺・横送り・送りのなすままに痕が並ぶ</translation>
    </message>
    <message>
        <source>Side of the patches</source>
        <translation>パッチの一辺</translation>
    </message>
    <message>
        <source>Distance of neighbouring passes</source>
        <translation>隣り合う経路の間隔</translation>
    </message>
    <message>
        <source>Distance of marks along the path; 0: from the tool controller&apos;s feed and spindle speed</source>
        <translation>経路に沿う痕の間隔; 0: 工具コントローラーの送りと回転数から</translation>
    </message>
    <message>
        <source>1: corners and apex on the faces; 0: flat; other values exaggerate or invert the pyramid</source>
        <translation>1: 角と頂点が面上; 0: 平ら; 他の値はピラミッドを強調または反転</translation>
    </message>
    <message>
        <source>Added to the height of each apex</source>
        <translation>各頂点の高さに加える値</translation>
    </message>
    <message>
        <source>Lines in planes along X, or contours at levels</source>
        <translation>Xに沿う平面内の線、または等高線</translation>
    </message>
    <message>
        <source>Layers from the stock, the last pass, or both</source>
        <translation>素材からの層、最後の仕上げ、または両方</translation>
    </message>
    <message>
        <source>Distance between lines</source>
        <translation>線の間隔</translation>
    </message>
    <message>
        <source>Distance between layers</source>
        <translation>層の間隔</translation>
    </message>
    <message>
        <source>The last pass&apos;s; 0: as the others&apos;</source>
        <translation>最後の仕上げの値; 0: 他と同じ</translation>
    </message>
    <message>
        <source>Left by roughing for the last pass</source>
        <translation>荒削りが仕上げに残す量</translation>
    </message>
    <message>
        <source>Of the path from the model</source>
        <translation>モデルからの経路の許容差</translation>
    </message>
    <message>
        <source>What is taken from the voxel model</source>
        <translation>ボクセルモデルから取るもの</translation>
    </message>
    <message>
        <source>Side of a voxel</source>
        <translation>ボクセルの一辺</translation>
    </message>
    <message>
        <source>Feed at the product&apos;s surface, V_Lo</source>
        <translation>製品表面での送り V_Lo</translation>
    </message>
    <message>
        <source>Feed at the skin of the stock, V_Hi</source>
        <translation>素材表面での送り V_Hi</translation>
    </message>
    <message>
        <source>Feed where nothing is left to cut; 0: as elsewhere</source>
        <translation>削るもののない所の送り; 0: 他と同じ</translation>
    </message>
    <message>
        <source>Moves that go down steeply never get faster</source>
        <translation>急に下る移動は速くしない</translation>
    </message>
    <message>
        <source>Other materials in the stock: &apos;name factor where&apos;, a factor on the feed, and a depth in mm below the stock&apos;s surface or the name of a solid</source>
        <translation>素材内の他の材料: &apos;名前 係数 場所&apos;、送りの係数と、素材表面からの深さ (mm) またはソリッドの名前</translation>
    </message>
    <message>
        <source>Whether the values at the skin of the stock are held, or are only where diffusion begins</source>
        <translation>素材表面の値を保つか、拡散の初期値とするだけか</translation>
    </message>
    <message>
        <source>Of the feed: to its steady state, or for a time as in the paper</source>
        <translation>送りの拡散: 定常状態まで、または論文のように一定時間</translation>
    </message>
    <message>
        <source>Of a transient diffusion, in seconds</source>
        <translation>非定常拡散の時間 (秒)</translation>
    </message>
    <message>
        <source>Of a transient diffusion, in mm^2/s</source>
        <translation>非定常拡散の係数 (mm^2/s)</translation>
    </message>
    <message>
        <source>Divide a time step that is too long for the voxels</source>
        <translation>ボクセルに対して長すぎる時間刻みを分ける</translation>
    </message>
    <message>
        <source>Diffuse the two angles (as in the paper) or the unit vector of the axis</source>
        <translation>二つの角 (論文のとおり) または軸の単位ベクトルを拡散する</translation>
    </message>
    <message>
        <source>Greatest angle of the posture about X and about Y</source>
        <translation>姿勢のXまわりとYまわりの最大角</translation>
    </message>
    <message>
        <source>Interpolate between voxels, or take each voxel&apos;s value (the paper&apos;s staircase)</source>
        <translation>ボクセル間を補間する、または各ボクセルの値を取る (論文の階段)</translation>
    </message>
    <message>
        <source>Where the voxels are read</source>
        <translation>ボクセルを読む位置</translation>
    </message>
    <message>
        <source>Of a move&apos;s feed from the field&apos;s</source>
        <translation>移動の送りと場の送りの許容差</translation>
    </message>
    <message>
        <source>Of the axis along a move</source>
        <translation>移動に沿う軸の許容差</translation>
    </message>
    <message>
        <source>Name of the machine file; empty: no limits</source>
        <translation>機械ファイルの名前; 空: 制限なし</translation>
    </message>
    <message>
        <source>Frusta of shank and holder: &apos;from to diameter diameter&apos;, heights above the tip in mm</source>
        <translation>シャンクとホルダーの円錐台: &apos;下 上 直径 直径&apos;、先端からの高さ (mm)</translation>
    </message>
    <message>
        <source>That is kept between holder and part</source>
        <translation>ホルダーと部品の間に保つ距離</translation>
    </message>
    <message>
        <source>Of the triangles that stand for the shapes</source>
        <translation>形状を表す三角形の許容差</translation>
    </message>
    <message>
        <source>For the voxel model and its fields, in MiB</source>
        <translation>ボクセルモデルと場のためのメモリー (MiB)</translation>
    </message>
    <message>
        <source>Dimples that are milled</source>
        <translation>削られるくぼみ</translation>
    </message>
    <message>
        <source>Lattice points left out, by reason</source>
        <translation>除かれた格子点 (理由別)</translation>
    </message>
    <message>
        <source>Mean spindle turns from dimple to dimple</source>
        <translation>くぼみからくぼみまでの平均スピンドル回転数</translation>
    </message>
    <message>
        <source>Whether the machine can hold the phase</source>
        <translation>機械が位相を保てるか</translation>
    </message>
    <message>
        <source>Distance of neighbouring dimples</source>
        <translation>隣り合うくぼみの間隔</translation>
    </message>
    <message>
        <source>Depth of the dimples</source>
        <translation>くぼみの深さ</translation>
    </message>
    <message>
        <source>Diameter of a dimple&apos;s rim</source>
        <translation>くぼみの縁の直径</translation>
    </message>
    <message>
        <source>Share of the faces that is dimple, 0 to 1</source>
        <translation>くぼみが占める面の割合、0〜1</translation>
    </message>
    <message>
        <source>Height of what stays between dimples</source>
        <translation>くぼみの間に残る高さ</translation>
    </message>
    <message>
        <source>Tilt below which the tip rubs in a dimple</source>
        <translation>くぼみで先端がこする限界の傾き</translation>
    </message>
    <message>
        <source>Milled dimples in which the tip rubs</source>
        <translation>先端がこする加工済みのくぼみ</translation>
    </message>
    <message>
        <source>Least distance of any two dimples, straight in space</source>
        <translation>任意の二つのくぼみの最小直線距離</translation>
    </message>
    <message>
        <source>Greatest distance of neighbours, measured</source>
        <translation>隣同士の最大距離 (測定)</translation>
    </message>
    <message>
        <source>Root mean square of distance / spacing - 1</source>
        <translation>距離 / 間隔 - 1 の二乗平均平方根</translation>
    </message>
    <message>
        <source>Least angle of lattice directions, measured</source>
        <translation>格子方向の最小角 (測定)</translation>
    </message>
    <message>
        <source>Greatest angle of lattice directions, measured</source>
        <translation>格子方向の最大角 (測定)</translation>
    </message>
    <message>
        <source>Milled dimples, each worth a cell of the lattice, over the faces&apos; area; 0: not known</source>
        <translation>加工されるくぼみ (一つを格子の一目と数える) と面の面積の比; 0: 不明</translation>
    </message>
    <message>
        <source>What was decided for you, and what is not covered</source>
        <translation>自動で決めたことと、覆われない所</translation>
    </message>
    <message>
        <source>Direction of the projection</source>
        <translation>投影の方向</translation>
    </message>
    <message>
        <source>How marks of neighbouring passes stand</source>
        <translation>隣り合う経路の痕の並び方</translation>
    </message>
    <message>
        <source>Predicted drift from pass to pass, in teeth</source>
        <translation>経路ごとの予測ずれ (刃数)</translation>
    </message>
    <message>
        <source>The same, measured on the path</source>
        <translation>同じ、経路上で測定</translation>
    </message>
    <message>
        <source>Largest difference of the phase measured on the path and predicted, in teeth</source>
        <translation>経路上で測った位相と予測の最大差 (刃数)</translation>
    </message>
    <message>
        <source>Of the path</source>
        <translation>経路の長さ</translation>
    </message>
    <message>
        <source>Ridge between lines on a flat, in mm</source>
        <translation>平面上の線間の尾根 (mm)</translation>
    </message>
    <message>
        <source>Lines left out: in a cavity, not reached from above</source>
        <translation>除かれた線: 空洞内で上から届かない</translation>
    </message>
    <message>
        <source>Timed moves</source>
        <translation>時間を定めた移動</translation>
    </message>
    <message>
        <source>The base operation&apos;s, in seconds</source>
        <translation>元の加工の時間 (秒)</translation>
    </message>
    <message>
        <source>Between moves that go straight on, in mm/min</source>
        <translation>直進する移動の間の差 (mm/min)</translation>
    </message>
    <message>
        <source>Within a move, in degrees</source>
        <translation>一つの移動の中の角度 (度)</translation>
    </message>
    <message>
        <source>That are stored</source>
        <translation>保存されている数</translation>
    </message>
    <message>
        <source>Places where no axis keeps the holder clear</source>
        <translation>どの軸でもホルダーが当たる所</translation>
    </message>
    <message>
        <source>Stock and model of the job: recomputed when they change</source>
        <translation>ジョブの素材とモデル: 変わると再計算されます</translation>
    </message>
    <message>
        <source>Path to modify</source>
        <translation>修正する経路</translation>
    </message>
    <message>
        <source>Number of the patch, in milling order, with which the program ends; 0: with the last one</source>
        <translation>プログラムを終えるパッチの加工順の番号; 0: 最後のパッチ</translation>
    </message>
    <message>
        <source>Stop before each patch if the operator has switched optional stops on (M1)</source>
        <translation>オプショナルストップが有効なら各パッチの前で止まる (M1)</translation>
    </message>
    <message>
        <source>Cutting end and flutes may cut so deep below the model, besides Tolerance</source>
        <translation>先端と刃がモデルの下へ切り込んでよい深さ (許容差を除く)</translation>
    </message>
    <message>
        <source>Cutting end and flutes may cut so deep below the model, besides the tolerance of copy milling under it</source>
        <translation>先端と刃がモデルの下へ切り込んでよい深さ (元の倣い加工の許容差を除く)</translation>
    </message>
    <message>
        <source>Time of all moves, rapids too, in seconds</source>
        <translation>早送りを含む全移動の時間 (秒)</translation>
    </message>
    <message>
        <source>Tool controller of the operation that is modified</source>
        <translation>修飾される加工の工具コントローラー</translation>
    </message>
    <message>
        <source>Time that FreeCAD counts for the job</source>
        <translation>FreeCADがジョブについて数える時間</translation>
    </message>
    <message>
        <source>Whether the operation that is modified is switched on</source>
        <translation>修飾される加工が有効かどうか</translation>
    </message>
    <message>
        <source>Name of the machine file, whose rapids and accelerations the time counts; empty: unknown</source>
        <translation>機械ファイルの名前。その早送りと加速度が時間に算入されます。空欄: 不明</translation>
    </message>
</context>
<context>
    <name>PatchMill</name>
    <message>
        <source>Spacing</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>Texture kind</source>
        <translation>テクスチャの種類</translation>
    </message>
    <message>
        <source>Overlapping</source>
        <translation>重なりあり</translation>
    </message>
    <message>
        <source>Isolated</source>
        <translation>独立</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深さ</translation>
    </message>
    <message>
        <source>Dimple diameter</source>
        <translation>ディンプル直径</translation>
    </message>
    <message>
        <source>Area share</source>
        <translation>面積率</translation>
    </message>
    <message>
        <source>Ridge height</source>
        <translation>リッジ高さ</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>配置方法</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>テクスチャ</translation>
    </message>
    <message>
        <source>Projected</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>On surface</source>
        <translation>面に沿う</translation>
    </message>
    <message>
        <source>Patch shape</source>
        <translation>パッチの形</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>正方形</translation>
    </message>
    <message>
        <source>Hexagon</source>
        <translation>六角形</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>長方形</translation>
    </message>
    <message>
        <source>Patch side</source>
        <translation>パッチの辺</translation>
    </message>
    <message>
        <source>Patch side across</source>
        <translation>パッチの他辺</translation>
    </message>
    <message>
        <source>Patches X</source>
        <translation>パッチ数 X</translation>
    </message>
    <message>
        <source>Patches Y</source>
        <translation>パッチ数 Y</translation>
    </message>
    <message>
        <source>Helix order</source>
        <translation>らせんの向き</translation>
    </message>
    <message>
        <source>Inward</source>
        <translation>内向き</translation>
    </message>
    <message>
        <source>Outward</source>
        <translation>外向き</translation>
    </message>
    <message>
        <source>Helix start</source>
        <translation>らせんの開始</translation>
    </message>
    <message>
        <source>Same corner</source>
        <translation>同じ角</translation>
    </message>
    <message>
        <source>Nearest corner</source>
        <translation>最寄りの角</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>加工順</translation>
    </message>
    <message>
        <source>Helix</source>
        <translation>らせん</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Row extent</source>
        <translation>行の範囲</translation>
    </message>
    <message>
        <source>Whole face</source>
        <translation>面全体</translation>
    </message>
    <message>
        <source>Each patch</source>
        <translation>パッチごと</translation>
    </message>
    <message>
        <source>Row direction</source>
        <translation>行の方向</translation>
    </message>
    <message>
        <source>Least time</source>
        <translation>最短時間</translation>
    </message>
    <message>
        <source>Along X</source>
        <translation>X 方向</translation>
    </message>
    <message>
        <source>Along Y</source>
        <translation>Y 方向</translation>
    </message>
    <message>
        <source>Principal curvature</source>
        <translation>主曲率</translation>
    </message>
    <message>
        <source>Rows one way</source>
        <translation>行は一方向のみ</translation>
    </message>
    <message>
        <source>First patch</source>
        <translation>最初のパッチ</translation>
    </message>
    <message>
        <source>Patch comments</source>
        <translation>パッチのコメント</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Auto direction</source>
        <translation>方向の自動設定</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Auto origin</source>
        <translation>原点の自動設定</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>原点</translation>
    </message>
    <message>
        <source>Steepest slope</source>
        <translation>最大傾斜</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>制限</translation>
    </message>
    <message>
        <source>Minimum tilt</source>
        <translation>最小傾き</translation>
    </message>
    <message>
        <source>Avoid rubbing</source>
        <translation>擦れを避ける</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>余白</translation>
    </message>
    <message>
        <source>Minimum dimples</source>
        <translation>最小ディンプル数</translation>
    </message>
    <message>
        <source>Mask use</source>
        <translation>マスクの用途</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>マスク</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>除外</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Mask image</source>
        <translation>マスク画像</translation>
    </message>
    <message>
        <source>Mask curves</source>
        <translation>マスク曲線</translation>
    </message>
    <message>
        <source>Mask invert</source>
        <translation>マスク反転</translation>
    </message>
    <message>
        <source>Mask width</source>
        <translation>マスクの幅</translation>
    </message>
    <message>
        <source>Mask centre</source>
        <translation>マスクの中心</translation>
    </message>
    <message>
        <source>Mask threshold</source>
        <translation>マスクのしきい値</translation>
    </message>
    <message>
        <source>Depth at black</source>
        <translation>黒での深さ</translation>
    </message>
    <message>
        <source>Depth at white</source>
        <translation>白での深さ</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>方式</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>位相</translation>
    </message>
    <message>
        <source>Constant feed</source>
        <translation>一定送り</translation>
    </message>
    <message>
        <source>Constant feed, fitted stops</source>
        <translation>一定送り・停止調整</translation>
    </message>
    <message>
        <source>Feed per move</source>
        <translation>移動ごとの送り</translation>
    </message>
    <message>
        <source>Spindle-locked</source>
        <translation>主軸同期</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>機械</translation>
    </message>
    <message>
        <source>Post unheld</source>
        <translation>位相不保持でも出力</translation>
    </message>
    <message>
        <source>Gouge tolerance</source>
        <translation>食い込み許容値</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>検査</translation>
    </message>
    <message>
        <source>Tool clearance</source>
        <translation>工具クリアランス</translation>
    </message>
    <message>
        <source>Stick out</source>
        <translation>突き出し長さ</translation>
    </message>
    <message>
        <source>Holder diameter</source>
        <translation>ホルダ直径</translation>
    </message>
    <message>
        <source>Holder length</source>
        <translation>ホルダ長さ</translation>
    </message>
    <message>
        <source>Post gouging</source>
        <translation>食い込みでも出力</translation>
    </message>
    <message>
        <source>Tool axis mode</source>
        <translation>工具軸モード</translation>
    </message>
    <message>
        <source>Tool axis</source>
        <translation>工具軸</translation>
    </message>
    <message>
        <source>Fixed</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>法線</translation>
    </message>
    <message>
        <source>Minimum lead</source>
        <translation>最小リード角</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>場</translation>
    </message>
    <message>
        <source>Fixed axis</source>
        <translation>固定軸</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>リード角</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>傾き</translation>
    </message>
    <message>
        <source>Lead towards</source>
        <translation>リード方向</translation>
    </message>
    <message>
        <source>Posture field</source>
        <translation>姿勢場</translation>
    </message>
    <message>
        <source>Field voxel size</source>
        <translation>場のボクセル寸法</translation>
    </message>
    <message>
        <source>Axis smoothing</source>
        <translation>軸の平滑化</translation>
    </message>
    <message>
        <source>Widest tilt</source>
        <translation>最大傾き</translation>
    </message>
    <message>
        <source>Row tolerance</source>
        <translation>行の許容値</translation>
    </message>
    <message>
        <source>Program form</source>
        <translation>プログラム形式</translation>
    </message>
    <message>
        <source>As the machine</source>
        <translation>機械に従う</translation>
    </message>
    <message>
        <source>With TCP</source>
        <translation>TCP あり</translation>
    </message>
    <message>
        <source>Without TCP</source>
        <translation>TCP なし</translation>
    </message>
    <message>
        <source>Gauge length</source>
        <translation>ゲージ長</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>リフト</translation>
    </message>
    <message>
        <source>Same flute</source>
        <translation>同じ刃</translation>
    </message>
    <message>
        <source>Extra turns</source>
        <translation>追加回転</translation>
    </message>
    <message>
        <source>Phase step</source>
        <translation>位相ステップ</translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation>小数桁数</translation>
    </message>
    <message>
        <source>Phase tolerance</source>
        <translation>位相許容値</translation>
    </message>
    <message>
        <source>Plane fit</source>
        <translation>平面の当てはめ</translation>
    </message>
    <message>
        <source>Best fit</source>
        <translation>最適</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>角</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Free form</source>
        <translation>自由形式</translation>
    </message>
    <message>
        <source>Lattice</source>
        <translation>格子</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Free side</source>
        <translation>自由形式の辺</translation>
    </message>
    <message>
        <source>Cross feed</source>
        <translation>ピックフィード</translation>
    </message>
    <message>
        <source>Feed per tooth</source>
        <translation>一刃送り</translation>
    </message>
    <message>
        <source>Height factor</source>
        <translation>高さ係数</translation>
    </message>
    <message>
        <source>Apex lift</source>
        <translation>頂点の持ち上げ</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>モード</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>倣い</translation>
    </message>
    <message>
        <source>Scanning</source>
        <translation>走査線</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>等高線</translation>
    </message>
    <message>
        <source>Scanning with undercuts</source>
        <translation>アンダーカット走査線</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>パス</translation>
    </message>
    <message>
        <source>Roughing and finishing</source>
        <translation>荒加工と仕上げ</translation>
    </message>
    <message>
        <source>Roughing</source>
        <translation>荒加工</translation>
    </message>
    <message>
        <source>Finishing</source>
        <translation>仕上げ</translation>
    </message>
    <message>
        <source>Radial depth</source>
        <translation>径方向切込み</translation>
    </message>
    <message>
        <source>Axial depth</source>
        <translation>軸方向切込み</translation>
    </message>
    <message>
        <source>Finishing radial depth</source>
        <translation>仕上げの径方向切込み</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>取り代</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>許容差</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>制御対象</translation>
    </message>
    <message>
        <source>DCM</source>
        <translation>DCM</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>送り速度</translation>
    </message>
    <message>
        <source>Posture</source>
        <translation>姿勢</translation>
    </message>
    <message>
        <source>Feed and posture</source>
        <translation>送りと姿勢</translation>
    </message>
    <message>
        <source>Voxel size</source>
        <translation>ボクセル寸法</translation>
    </message>
    <message>
        <source>Feed at product</source>
        <translation>製品面での送り</translation>
    </message>
    <message>
        <source>Feed at skin</source>
        <translation>素材表面での送り</translation>
    </message>
    <message>
        <source>Feed in air</source>
        <translation>空中での送り</translation>
    </message>
    <message>
        <source>Keep plunges</source>
        <translation>突込みを維持</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Exterior</source>
        <translation>外部</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Diffusion</source>
        <translation>拡散</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>定常</translation>
    </message>
    <message>
        <source>Transient</source>
        <translation>過渡</translation>
    </message>
    <message>
        <source>Diffusion time</source>
        <translation>拡散時間</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>時間刻み</translation>
    </message>
    <message>
        <source>Diffusivity</source>
        <translation>拡散率</translation>
    </message>
    <message>
        <source>Sub steps</source>
        <translation>サブステップ</translation>
    </message>
    <message>
        <source>Posture form</source>
        <translation>姿勢の形式</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Unit vector</source>
        <translation>単位ベクトル</translation>
    </message>
    <message>
        <source>Tilt limit</source>
        <translation>傾き制限</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>読取り</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>滑らか</translation>
    </message>
    <message>
        <source>Staircase</source>
        <translation>階段状</translation>
    </message>
    <message>
        <source>Read at</source>
        <translation>読取り位置</translation>
    </message>
    <message>
        <source>Ball centre</source>
        <translation>ボール中心</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>先端</translation>
    </message>
    <message>
        <source>Feed tolerance</source>
        <translation>送り許容差</translation>
    </message>
    <message>
        <source>Axis tolerance</source>
        <translation>軸許容差</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>ホルダ</translation>
    </message>
    <message>
        <source>Holder clearance</source>
        <translation>ホルダクリアランス</translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation>弦誤差</translation>
    </message>
    <message>
        <source>Memory limit</source>
        <translation>メモリ上限</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>加工</translation>
    </message>
    <message>
        <source>off the face</source>
        <translation>面外</translation>
    </message>
    <message>
        <source>too steep</source>
        <translation>急すぎ</translation>
    </message>
    <message>
        <source>tool tip</source>
        <translation>工具先端</translation>
    </message>
    <message>
        <source>undercut</source>
        <translation>アンダーカット</translation>
    </message>
    <message>
        <source>near an edge</source>
        <translation>縁の近く</translation>
    </message>
    <message>
        <source>sliver</source>
        <translation>端切れ</translation>
    </message>
    <message>
        <source>masked</source>
        <translation>マスク</translation>
    </message>
    <message>
        <source>no facet</source>
        <translation>ファセットなし</translation>
    </message>
    <message>
        <source>off the net</source>
        <translation>網の外</translation>
    </message>
    <message>
        <source>crowded</source>
        <translation>過密</translation>
    </message>
    <message>
        <source>square</source>
        <translation>正方</translation>
    </message>
    <message>
        <source>staggered</source>
        <translation>千鳥</translation>
    </message>
    <message>
        <source>oblique</source>
        <translation>斜交</translation>
    </message>
    <message>
        <source>irregular</source>
        <translation>不規則</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>運動</translation>
    </message>
    <message>
        <source>Dimples planned</source>
        <translation>計画ディンプル</translation>
    </message>
    <message>
        <source>found</source>
        <translation>検出</translation>
    </message>
    <message>
        <source>marks that nobody planned</source>
        <translation>計画外の切削痕</translation>
    </message>
    <message>
        <source>off their places, rms</source>
        <translation>位置ずれ (rms)</translation>
    </message>
    <message>
        <source>depth to the rim</source>
        <translation>縁からの深さ</translation>
    </message>
    <message>
        <source>diameter, mean</source>
        <translation>平均直径</translation>
    </message>
    <message>
        <source>distance to the nearest, mean</source>
        <translation>最近接距離の平均</translation>
    </message>
    <message>
        <source>array</source>
        <translation>配列</translation>
    </message>
    <message>
        <source>quality, 0 to 1</source>
        <translation>品質 (0–1)</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>spindle lock</source>
        <translation>主軸同期</translation>
    </message>
    <message>
        <source>decimals</source>
        <translation>小数桁数</translation>
    </message>
    <message>
        <source>servo period</source>
        <translation>サーボ周期</translation>
    </message>
    <message>
        <source>path tolerance</source>
        <translation>経路許容差</translation>
    </message>
    <message>
        <source>linear axes</source>
        <translation>直線軸</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>jerk</source>
        <translation>ジャーク</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>限界</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>start phase</source>
        <translation>開始位相</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>rotary axis C</source>
        <translation>回転軸 C</translation>
    </message>
    <message>
        <source>letter</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>side</source>
        <translation>側</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>rotary axis A</source>
        <translation>回転軸 A</translation>
    </message>
    <message>
        <source>work zero</source>
        <translation>ワーク原点</translation>
    </message>
    <message>
        <source>retract</source>
        <translation>退避</translation>
    </message>
    <message>
        <source>controller</source>
        <translation>制御装置</translation>
    </message>
    <message>
        <source>dialect</source>
        <translation>方言</translation>
    </message>
    <message>
        <source>TCP</source>
        <translation>TCP</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>基準点</translation>
    </message>
    <message>
        <source>TCP on</source>
        <translation>TCP オン</translation>
    </message>
    <message>
        <source>TCP off</source>
        <translation>TCP オフ</translation>
    </message>
    <message>
        <source>smoothing on</source>
        <translation>平滑化オン</translation>
    </message>
    <message>
        <source>smoothing off</source>
        <translation>平滑化オフ</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>オペレータ</translation>
    </message>
    <message>
        <source>controller version</source>
        <translation>制御装置の版</translation>
    </message>
    <message>
        <source>lock origin</source>
        <translation>同期の原点</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>校正</translation>
    </message>
    <message>
        <source>spindle rpm</source>
        <translation>主軸回転数</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>ピッチ</translation>
    </message>
    <message>
        <source>rotary axis B</source>
        <translation>回転軸 B</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>no face</source>
        <translation>面なし</translation>
    </message>
    <message>
        <source>select faces to texture.</source>
        <translation>テクスチャを付ける面を選択してください。</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>select a part or its faces.</source>
        <translation>部品またはその面を選択してください。</translation>
    </message>
    <message>
        <source>{} operations</source>
        <translation>{} 個の加工</translation>
    </message>
    <message>
        <source>select one operation of a job.</source>
        <translation>ジョブの加工を 1 つ選択してください。</translation>
    </message>
    <message>
        <source>Folder for the report</source>
        <translation>レポートのフォルダ</translation>
    </message>
    <message>
        <source>PatchMill&apos;s compiled core</source>
        <translation>PatchMill のコンパイル済みコア</translation>
    </message>
    <message>
        <source>Documents with PatchMill&apos;s operations can be opened and saved; nothing is lost.</source>
        <translation>PatchMill の加工を含む文書は開いて保存できます。何も失われません。</translation>
    </message>
    <message>
        <source>Install</source>
        <translation>インストール</translation>
    </message>
    <message>
        <source>Install from a wheel file …</source>
        <translation>wheel ファイルからインストール …</translation>
    </message>
    <message>
        <source>Copy the command for a terminal</source>
        <translation>端末用コマンドをコピー</translation>
    </message>
    <message>
        <source>A wheel of PatchMill&apos;s core</source>
        <translation>PatchMill コアの wheel</translation>
    </message>
    <message>
        <source>Copied. Start FreeCAD again when it has run.</source>
        <translation>コピーしました。実行後に FreeCAD を再起動してください。</translation>
    </message>
    <message>
        <source>Installed. Start FreeCAD again to use it.</source>
        <translation>インストールしました。FreeCAD を再起動してください。</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>詳細設定</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Marks in rows</source>
        <translation>切削痕の整列</translation>
    </message>
    <message>
        <source>Staggered</source>
        <translation>千鳥</translation>
    </message>
    <message>
        <source>Propose</source>
        <translation>提案</translation>
    </message>
    <message>
        <source>side {:.4f} mm, cross-feed {:.4f} mm, feed per tooth {:.4f} mm: {}</source>
        <translation>辺 {:.4f} mm、ピックフィード {:.4f} mm、一刃送り {:.4f} mm: {}</translation>
    </message>
    <message>
        <source>(none: phase not judged)</source>
        <translation>(なし: 位相を判定しない)</translation>
    </message>
    <message>
        <source>(none: no limits)</source>
        <translation>(なし: 制限なし)</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>(なし)</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>機械</translation>
    </message>
    <message>
        <source>What</source>
        <translation>項目</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation>名前を付けて保存 …</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>インポート …</translation>
    </message>
    <message>
        <source>Remove my file</source>
        <translation>自分のファイルを削除</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Reads the configuration of a LinuxCNC machine</source>
        <translation>LinuxCNC 機の設定を読み込みます</translation>
    </message>
    <message>
        <source>Your own file.</source>
        <translation>自分のファイルです。</translation>
    </message>
    <message>
        <source>Comes with PatchMill.</source>
        <translation>PatchMill に付属。</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>名前を付けて保存</translation>
    </message>
    <message>
        <source>Name of the new machine file:</source>
        <translation>新しい機械ファイルの名前:</translation>
    </message>
    <message>
        <source>LinuxCNC configuration</source>
        <translation>LinuxCNC の設定</translation>
    </message>
    <message>
        <source>From {}; to be saved as {}.</source>
        <translation>{} から。{} として保存されます。</translation>
    </message>
    <message>
        <source>Close without saving what was changed?</source>
        <translation>変更を保存せずに閉じますか?</translation>
    </message>
    <message>
        <source>Post and check {}</source>
        <translation>{} を出力して検査</translation>
    </message>
    <message>
        <source>Post-&amp;processor</source>
        <translation>ポストプロセッサ(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Work offset</source>
        <translation>ワークオフセット(&amp;W)</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>Post</source>
        <translation>出力</translation>
    </message>
    <message>
        <source>none is named</source>
        <translation>指定なし</translation>
    </message>
    <message>
        <source>not judged: no machine is named</source>
        <translation>判定なし: 機械が指定されていません</translation>
    </message>
    <message>
        <source>no texture</source>
        <translation>テクスチャなし</translation>
    </message>
    <message>
        <source>Choose the program&apos;s file</source>
        <translation>プログラムのファイルを選択</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>{} was written. Not compared with the path: {}.</source>
        <translation>{} を書き込みました。経路との比較なし: {}。</translation>
    </message>
    <message>
        <source>{} was written, read back and holds the plan.</source>
        <translation>{} を書き込み、読み戻して計画どおりであることを確認しました。</translation>
    </message>
    <message>
        <source>{} dimples in {} patches</source>
        <translation>{} 個のディンプル、{} パッチ</translation>
    </message>
    <message>
        <source>{} of milling, {:.2f} turns per dimple</source>
        <translation>加工時間 {}、ディンプルあたり {:.2f} 回転</translation>
    </message>
    <message>
        <source>%p % · {:.0f} s left</source>
        <translation>%p % · 残り {:.0f} 秒</translation>
    </message>
    <message>
        <source>Check {}</source>
        <translation>{} を検査</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>検査中 …</translation>
    </message>
    <message>
        <source>{} moves, {} of milling, ridges of {} on a flat</source>
        <translation>{} 移動、加工時間 {}、平面でのリッジ {}</translation>
    </message>
    <message>
        <source>DCM modifier</source>
        <translation>DCM 修飾</translation>
    </message>
    <message>
        <source>Slice through the voxels</source>
        <translation>ボクセルの断面</translation>
    </message>
    <message>
        <source>across {}</source>
        <translation>{} に垂直</translation>
    </message>
    <message>
        <source>Distance to the product</source>
        <translation>製品までの距離</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Posture as arrows</source>
        <translation>姿勢を矢印で表示</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>At</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>{} moves, {} of milling instead of {}</source>
        <translation>{} 移動、加工時間 {} (元は {})</translation>
    </message>
    <message>
        <source>feed [{}]</source>
        <translation>送り [{}]</translation>
    </message>
    <message>
        <source>tilt [°]</source>
        <translation>傾き [°]</translation>
    </message>
    <message>
        <source>distance [{}]</source>
        <translation>距離 [{}]</translation>
    </message>
    <message>
        <source>Tool controller</source>
        <translation>ツールコントローラ</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>クーラント</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>{} of {}
move {} of {}{}
X {:.3f}  Y {:.3f}  Z {:.3f}
spindle {:.0f}°</source>
        <translation>{} / {}
移動 {} / {}{}
X {:.3f}  Y {:.3f}  Z {:.3f}
主軸 {:.0f}°</translation>
    </message>
    <message>
        <source>, to dimple {}</source>
        <translation>、ディンプル {} へ</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>レポート</translation>
    </message>
    <message>
        <source>Simulating and drawing …</source>
        <translation>シミュレーションと作図中 …</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>レポートを開く</translation>
    </message>
    <message>
        <source>Simulate marks</source>
        <translation>切削痕シミュレーション</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>Save relief …</source>
        <translation>レリーフを保存 …</translation>
    </message>
    <message>
        <source>As a height map or a mesh, or the dimples as a table</source>
        <translation>高さマップ、メッシュ、またはディンプルの表として</translation>
    </message>
    <message>
        <source>whole texture</source>
        <translation>テクスチャ全体</translation>
    </message>
    <message>
        <source>as planned</source>
        <translation>計画どおり</translation>
    </message>
    <message>
        <source>as {} would run it</source>
        <translation>{} の動作で</translation>
    </message>
    <message>
        <source>How far the first flute stands out</source>
        <translation>第 1 刃の突き出し量</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>Runout</source>
        <translation>振れ</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>Height map</source>
        <translation>高さマップ</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>メッシュ</translation>
    </message>
    <message>
        <source>Table of dimples</source>
        <translation>ディンプルの表</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>レリーフ</translation>
    </message>
    <message>
        <source>Looking for good values …</source>
        <translation>適切な値を探しています …</translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation>計算中 …</translation>
    </message>
    <message>
        <source>Looking for what helps …</source>
        <translation>改善策を探しています …</translation>
    </message>
    <message>
        <source>Nothing that was tried makes it better.</source>
        <translation>試した方法では改善しません。</translation>
    </message>
    <message>
        <source>Set for this strategy: any flute, no extra turns.</source>
        <translation>この方式用に設定: 任意の刃、追加回転なし。</translation>
    </message>
    <message>
        <source>{} dimples</source>
        <translation>{} 個のディンプル</translation>
    </message>
    <message>
        <source>quality {} of patches at {}° to {}°: {}</source>
        <translation>{1}°~{2}° のパッチの品質 {0}: {3}</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Tried: this is what it gives</source>
        <translation>試行済み: 結果はこのとおり</translation>
    </message>
    <message>
        <source>Not simulated</source>
        <translation>未シミュレーション</translation>
    </message>
    <message>
        <source>Good: {} of the faces as planned</source>
        <translation>良好: 面の {} が計画どおり</translation>
    </message>
    <message>
        <source>Good if the machine holds the phase: choose a machine to know</source>
        <translation>機械が位相を保てば良好: 機械を選ぶと判定します</translation>
    </message>
    <message>
        <source>{} of the faces good; {} left out</source>
        <translation>面の {} が良好、{} は除外</translation>
    </message>
    <message>
        <source>Incline the part {:.0f}°</source>
        <translation>部品を {:.0f}° 傾ける</translation>
    </message>
    <message>
        <source>Lean the tool {:.0f}°</source>
        <translation>工具を {:.0f}° 傾ける</translation>
    </message>
    <message>
        <source>Leave out what is too flat</source>
        <translation>平らすぎる部分を除外</translation>
    </message>
    <message>
        <source>Take the values that suit</source>
        <translation>適した値を使う</translation>
    </message>
    <message>
        <source>{}: {:.0f} % good, {}</source>
        <translation>{}: {:.0f} % 良好、{}</translation>
    </message>
    <message>
        <source>Dimples</source>
        <translation>ディンプル</translation>
    </message>
    <message>
        <source>Patches</source>
        <translation>パッチ</translation>
    </message>
    <message>
        <source>Tool axes</source>
        <translation>工具軸</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>Play the path</source>
        <translation>経路を再生</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>パターン</translation>
    </message>
    <message>
        <source>Quality {} with the borders of the faces, {} inside</source>
        <translation>品質は面の縁を含めて {}、内側で {}</translation>
    </message>
    <message>
        <source>Let the tool follow the faces, leant {:.0f}°</source>
        <translation>工具を面に沿わせ、{:.0f}° 傾ける</translation>
    </message>
    <message>
        <source>Choose a smaller spacing</source>
        <translation>間隔を小さくする</translation>
    </message>
    <message>
        <source>{}, spacing {}</source>
        <translation>{}、間隔 {}</translation>
    </message>
    <message>
        <source>{}, leave out what is too flat</source>
        <translation>{}、平らすぎる所を除く</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>主軸回転数</translation>
    </message>
    <message>
        <source>Find the best speed</source>
        <translation>最適な回転数を探す</translation>
    </message>
    <message>
        <source>Trying other speeds …</source>
        <translation>他の回転数を試しています …</translation>
    </message>
    <message>
        <source>No speed from S{} to S{} holds.</source>
        <translation>S{} から S{} までに位相を保つ回転数はありません。</translation>
    </message>
    <message>
        <source>S{} takes {:.0f} s, the phase off by up to {:.1f}°. None that holds is faster.</source>
        <translation>S{} では {:.0f} 秒、位相のずれは最大 {:.1f}°。位相を保つものでこれより速いものはありません。</translation>
    </message>
    <message>
        <source>Set S{}</source>
        <translation>S{} にする</translation>
    </message>
    <message>
        <source>Other operations use this tool controller: give this one its own.</source>
        <translation>このツールコントローラーは他の操作も使っています。専用のものを与えてください。</translation>
    </message>
    <message>
        <source>Last patch</source>
        <translation>最後のパッチ</translation>
    </message>
    <message>
        <source>Patch stops</source>
        <translation>パッチ間の停止</translation>
    </message>
    <message>
        <source>counted from</source>
        <translation>数え始め</translation>
    </message>
    <message>
        <source>{}, borders not as good</source>
        <translation>{}、縁はやや劣る</translation>
    </message>
    <message>
        <source>{} for PatchMill&apos;s operations</source>
        <translation>PatchMill の操作に {}</translation>
    </message>
    <message>
        <source>Play {}</source>
        <translation>{} を再生</translation>
    </message>
    <message>
        <source>Next finding</source>
        <translation>次の検出箇所</translation>
    </message>
    <message>
        <source>Goes on to where the check found something next</source>
        <translation>検査で見つかった次の箇所へ進みます</translation>
    </message>
    <message>
        <source>{:.0f} % of the faces look away or are too steep as the part lies</source>
        <translation>部品の今の向きでは、面の {:.0f} % が反対側を向いているか、急すぎます</translation>
    </message>
    <message>
        <source>Lay the dimples along the faces</source>
        <translation>ディンプルを面に沿って並べる</translation>
    </message>
    <message>
        <source>{}, dimples laid along the faces</source>
        <translation>{}、ディンプルを面に沿って配置</translation>
    </message>
    <message>
        <source>Leave out what is steeper than {:.0f}°</source>
        <translation>{:.0f}° より急な部分を除外</translation>
    </message>
    <message>
        <source>{}, leave out what is steeper than {:.0f}°</source>
        <translation>{}、{:.0f}° より急な所を除く</translation>
    </message>
    <message>
        <source>The faces bend in to a radius of {}; the ball of {} does not fit there.</source>
        <translation>面の凹みの半径は最小 {} で、半径 {} のボールは入りません。</translation>
    </message>
    <message>
        <source>{} of the faces as planned, their borders included</source>
        <translation>縁を含めて面の {} が計画どおり</translation>
    </message>
    <message>
        <source>{} of the faces good; the rest looks away: turn the part for it</source>
        <translation>面の {} が良好、残りは工具の反対側を向いています：そのために部品を回してください</translation>
    </message>
    <message>
        <source>The faces are about {} wide: {:.0f} dimples side by side are too few.</source>
        <translation>面の幅は約 {} です。並ぶディンプルが {:.0f} 個では足りません。</translation>
    </message>
    <message>
        <source>give a finite number.</source>
        <translation>有限の数を指定してください。</translation>
    </message>
    <message>
        <source>give a value greater than zero.</source>
        <translation>0 より大きい値を指定してください。</translation>
    </message>
    <message>
        <source>give a finite value greater than zero.</source>
        <translation>0 より大きい有限の値を指定してください。</translation>
    </message>
    <message>
        <source>give a value from {} to {} mm.</source>
        <translation>{} から {} mm の値を指定してください。</translation>
    </message>
    <message>
        <source>give a value from {} to {} degrees.</source>
        <translation>{} から {} 度の値を指定してください。</translation>
    </message>
    <message>
        <source>give more than zero.</source>
        <translation>0 より大きくしてください。</translation>
    </message>
    <message>
        <source>give zero or a positive length.</source>
        <translation>0 または正の長さを指定してください。</translation>
    </message>
    <message>
        <source>give a whole number greater than zero: posts write S so.</source>
        <translation>0 より大きい整数を指定してください。ポストは S を整数で書きます。</translation>
    </message>
    <message>
        <source>give the tool controller a feed.</source>
        <translation>ツールコントローラーに送り速度を設定してください。</translation>
    </message>
    <message>
        <source>give the operation a tool controller with a tool.</source>
        <translation>工具のあるツールコントローラーを操作に設定してください。</translation>
    </message>
    <message>
        <source>{} mm from the nearest dimple</source>
        <translation>最も近いディンプルから {} mm</translation>
    </message>
    <message>
        <source>a ball of radius {} mm leaves untouched material between the dimples: choose a smaller spacing or a larger ball.</source>
        <translation>半径 {} mm のボールではディンプルの間に削り残しが出ます。間隔を小さくするか、大きいボールを選んでください。</translation>
    </message>
    <message>
        <source>choose a larger ball or a smaller spacing.</source>
        <translation>大きいボールか小さい間隔を選んでください。</translation>
    </message>
    <message>
        <source>in dimples {} mm deep the tip of the ball would rub: incline the tool by more than {}°, or choose shallower dimples.</source>
        <translation>深さ {} mm のディンプルではボールの先端がこすれます。工具を {}° より大きく傾けるか、ディンプルを浅くしてください。</translation>
    </message>
    <message>
        <source>in dimples {} mm deep the tip of the ball would rub under a tilt of {} degrees, and the faces have {} at most: incline the part or choose shallower dimples.</source>
        <translation>深さ {} mm のディンプルでは傾き {} 度未満でボールの先端がこすれますが、面の傾きは最大 {} です。部品を傾けるか、ディンプルを浅くしてください。</translation>
    </message>
    <message>
        <source>on a paced path every flute passes in turn: allow any flute, or use the constant-feed strategy.</source>
        <translation>歩調を合わせた経路ではすべての刃が順に通ります。どの刃でもよいとするか、送り一定の方式を使ってください。</translation>
    </message>
    <message>
        <source>select a face of a solid or surface.</source>
        <translation>ソリッドまたはサーフェスの面を選択してください。</translation>
    </message>
    <message>
        <source>select at least one face of the job&apos;s model.</source>
        <translation>ジョブのモデルの面を少なくとも一つ選択してください。</translation>
    </message>
    <message>
        <source>it is gone: choose the faces again.</source>
        <translation>なくなっています。面を選び直してください。</translation>
    </message>
    <message>
        <source>give the job a stock.</source>
        <translation>ジョブに素材を設定してください。</translation>
    </message>
    <message>
        <source>give the job a model.</source>
        <translation>ジョブにモデルを設定してください。</translation>
    </message>
    <message>
        <source>it belongs to no job: make it in one.</source>
        <translation>どのジョブにも属していません。ジョブの中に作ってください。</translation>
    </message>
    <message>
        <source>choose a texture operation.</source>
        <translation>テクスチャ操作を選んでください。</translation>
    </message>
    <message>
        <source>repair the operation first.</source>
        <translation>先に操作を直してください。</translation>
    </message>
    <message>
        <source>copy milling takes a ball, bull nose, tapered or conical end mill: choose one.</source>
        <translation>倣い加工にはボール、ラジアス、テーパーボールまたは円錐のエンドミルが必要です。どれかを選んでください。</translation>
    </message>
    <message>
        <source>choose a ball, bull nose, flat, tapered ball or conical end mill.</source>
        <translation>ボール、ラジアス、フラット、テーパーボールまたは円錐のエンドミルを選んでください。</translation>
    </message>
    <message>
        <source>give no more than the tool&apos;s cutting edge, {} mm.</source>
        <translation>工具の刃長 {} mm 以下にしてください。</translation>
    </message>
    <message>
        <source>give no more than AxialDepth, {} mm: the last pass takes it all at once.</source>
        <translation>軸方向切込み {} mm 以下にしてください。最後のパスで一度に削ります。</translation>
    </message>
    <message>
        <source>rapids would go through the stock: give more than its top, {} mm.</source>
        <translation>早送りが素材を通ります。素材の上面 {} mm より大きくしてください。</translation>
    </message>
    <message>
        <source>there is nothing to cut on them, or the ball does not reach them from above.</source>
        <translation>削るものがないか、ボールが上から届きません。</translation>
    </message>
    <message>
        <source>with undercuts choose the whole model.</source>
        <translation>アンダーカットではモデル全体を選んでください。</translation>
    </message>
    <message>
        <source>tool axes other than Z need a machine file with rotary axes.</source>
        <translation>Z 以外の工具軸には回転軸のある機械ファイルが必要です。</translation>
    </message>
    <message>
        <source>name a machine file: without one nobody knows what it can follow.</source>
        <translation>機械ファイルを指定してください。ないと機械が何に追従できるか分かりません。</translation>
    </message>
    <message>
        <source>give a picture or closed curves, or choose None.</source>
        <translation>画像か閉じた曲線を指定するか、なしを選んでください。</translation>
    </message>
    <message>
        <source>it has an open curve: close it.</source>
        <translation>開いた曲線があります。閉じてください。</translation>
    </message>
    <message>
        <source>put it over the faces.</source>
        <translation>面の上に置いてください。</translation>
    </message>
    <message>
        <source>the job has no active operation.</source>
        <translation>ジョブに有効な操作がありません。</translation>
    </message>
    <message>
        <source>choose a post-processor for the job.</source>
        <translation>ジョブのポストプロセッサを選んでください。</translation>
    </message>
    <message>
        <source>name a file in a folder that can be written to.</source>
        <translation>書き込めるフォルダーのファイルを指定してください。</translation>
    </message>
    <message>
        <source>give the name of a file.</source>
        <translation>ファイル名を指定してください。</translation>
    </message>
    <message>
        <source>What {} leaves</source>
        <translation>{} の削り残し</translation>
    </message>
    <message>
        <source>Simulating …</source>
        <translation>シミュレーション中 …</translation>
    </message>
    <message>
        <source>left over the part [{}]</source>
        <translation>部品からの残り [{}]</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>検査</translation>
    </message>
    <message>
        <source>height over the faces [{}]</source>
        <translation>面からの高さ [{}]</translation>
    </message>
    <message>
        <source>part that is milled, seen from above</source>
        <translation>加工された割合（上から見て）</translation>
    </message>
    <message>
        <source>left over the part, mean</source>
        <translation>削り残しの平均</translation>
    </message>
    <message>
        <source>left over the part, at most</source>
        <translation>削り残しの最大</translation>
    </message>
    <message>
        <source>cut below the part, at most</source>
        <translation>削りすぎの最大</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>格子</translation>
    </message>
    <message>
        <source>Walls of the part beside the faces are in the tool&apos;s way.</source>
        <translation>面の横にある部品の壁が工具の邪魔になります。</translation>
    </message>
    <message>
        <source>Mill them in {} operations, the tool leant from each side</source>
        <translation>工具を各方向から傾け、{} 個の加工に分けて削る</translation>
    </message>
    <message>
        <source>Mill them in {} clampings, a job for each</source>
        <translation>{} 回の段取りに分け、それぞれ別のジョブで削る</translation>
    </message>
    <message>
        <source>{}, margin {} beside walls</source>
        <translation>{}、壁の横の余白 {}</translation>
    </message>
</context>
<context>
    <name>PatchMillPreferences</name>
    <message>
        <source>General</source>
        <translation>一般</translation>
    </message>
    <message>
        <source>New jobs: ball end mill and post-processor</source>
        <translation>新しいジョブ: ボールエンドミルとポストプロセッサ</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>刃数</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>主軸回転数</translation>
    </message>
    <message>
        <source> rpm</source>
        <translation> rpm</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>送り速度</translation>
    </message>
    <message>
        <source> mm/min</source>
        <translation> mm/min</translation>
    </message>
    <message>
        <source>Post-processor</source>
        <translation>ポストプロセッサ</translation>
    </message>
    <message>
        <source>linuxcnc</source>
        <translation>linuxcnc</translation>
    </message>
    <message>
        <source>New textures</source>
        <translation>新しいテクスチャ</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>Machine file</source>
        <translation>機械ファイル</translation>
    </message>
    <message>
        <source>Name of a machine file, such as linuxcnc-mill; empty: the phase is not judged</source>
        <translation>機械ファイルの名前 (例: linuxcnc-mill)。空欄: 位相を判定しない</translation>
    </message>
    <message>
        <source>Decimals of coordinates</source>
        <translation>座標の小数桁数</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>計算機</translation>
    </message>
    <message>
        <source>Memory of one computation</source>
        <translation>1 回の計算のメモリ</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Threads (from the next start)</source>
        <translation>スレッド数 (次回起動から)</translation>
    </message>
    <message>
        <source>all</source>
        <translation>すべて</translation>
    </message>
</context>
<context>
    <name>PatchMill_CalibrationPatch</name>
    <message>
        <source>Calibration patch</source>
        <translation>校正パッチ</translation>
    </message>
    <message>
        <source>One patch whose best dimple tells the machine&apos;s start phase</source>
        <translation>最良のディンプルから機械の開始位相がわかるパッチ</translation>
    </message>
</context>
<context>
    <name>PatchMill_Check</name>
    <message>
        <source>Check</source>
        <translation>検査</translation>
    </message>
    <message>
        <source>Looks for gouges and collisions of ball, shank and holder with the part</source>
        <translation>ボール、シャンク、ホルダの食い込みと干渉を調べます</translation>
    </message>
</context>
<context>
    <name>PatchMill_CopyMilling</name>
    <message>
        <source>Copy milling</source>
        <translation>倣い加工</translation>
    </message>
    <message>
        <source>Lines over the selected faces or the whole part, layer by layer</source>
        <translation>選択した面または部品全体を層ごとに走査</translation>
    </message>
</context>
<context>
    <name>PatchMill_CurvedTexture</name>
    <message>
        <source>Curved texture</source>
        <translation>曲面テクスチャ</translation>
    </message>
    <message>
        <source>Dimples that lie on the selected faces (Xu and Sasahara 2016)</source>
        <translation>選択した面上のディンプル (Xu・笹原 2016)</translation>
    </message>
</context>
<context>
    <name>PatchMill_DressupDcm</name>
    <message>
        <source>DCM modifier</source>
        <translation>DCM 修飾</translation>
    </message>
    <message>
        <source>Feed and tool posture of the selected operation from a voxel model</source>
        <translation>ボクセルモデルから選択した加工の送りと工具姿勢を決定</translation>
    </message>
</context>
<context>
    <name>PatchMill_Examples</name>
    <message>
        <source>Free-form block: curved texture</source>
        <translation>自由曲面ブロック: 曲面テクスチャ</translation>
    </message>
    <message>
        <source>The part of Xu and Sasahara 2016</source>
        <translation>Xu・笹原 2016 の部品</translation>
    </message>
    <message>
        <source>Inclined plane: planar texture</source>
        <translation>傾斜平面: 平面テクスチャ</translation>
    </message>
    <message>
        <source>After Matsuda, Sasahara and Tsutsumi 2008</source>
        <translation>松田・笹原・堤 2008 による</translation>
    </message>
    <message>
        <source>Cylinder: planar patches on the surface</source>
        <translation>円筒: 面上の平面パッチ</translation>
    </message>
    <message>
        <source>Smooth part: copy milling and DCM feed</source>
        <translation>滑らかな部品: 倣い加工と DCM 送り</translation>
    </message>
    <message>
        <source>After Kobayashi and Shirase 2014, feed</source>
        <translation>小林・白瀬 2014 による (送り)</translation>
    </message>
    <message>
        <source>Overhanging part: DCM posture</source>
        <translation>オーバーハング部品: DCM 姿勢</translation>
    </message>
    <message>
        <source>After Kobayashi and Shirase 2014, posture</source>
        <translation>小林・白瀬 2014 による (姿勢)</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>例</translation>
    </message>
    <message>
        <source>Parts that are ready to be tried</source>
        <translation>すぐ試せる部品</translation>
    </message>
</context>
<context>
    <name>PatchMill_InstallCore</name>
    <message>
        <source>Install PatchMill&apos;s core …</source>
        <translation>PatchMill のコアをインストール …</translation>
    </message>
    <message>
        <source>What is missing here, and how to get it</source>
        <translation>不足しているものと入手方法</translation>
    </message>
</context>
<context>
    <name>PatchMill_Machines</name>
    <message>
        <source>Machines …</source>
        <translation>機械 …</translation>
    </message>
    <message>
        <source>Limits, rotary axes and controller of your machines</source>
        <translation>機械の制限、回転軸、制御装置</translation>
    </message>
</context>
<context>
    <name>PatchMill_PlanarTexture</name>
    <message>
        <source>Planar texture</source>
        <translation>平面テクスチャ</translation>
    </message>
    <message>
        <source>Dimples in flat patches on the selected faces (Matsuda 2008)</source>
        <translation>選択した面上の平面パッチのディンプル (松田 2008)</translation>
    </message>
</context>
<context>
    <name>PatchMill_Play</name>
    <message>
        <source>Play the path</source>
        <translation>経路を再生</translation>
    </message>
    <message>
        <source>Moves the tool along a path, with its spindle turning</source>
        <translation>主軸を回しながら工具を経路に沿って動かします</translation>
    </message>
</context>
<context>
    <name>PatchMill_Post</name>
    <message>
        <source>Post and check</source>
        <translation>出力と検査</translation>
    </message>
    <message>
        <source>Writes the program, if what is read back from its text holds the plan</source>
        <translation>読み戻した内容が計画どおりならプログラムを書き込みます</translation>
    </message>
</context>
<context>
    <name>PatchMill_PyramidTexture</name>
    <message>
        <source>Pyramid texture</source>
        <translation>ピラミッドテクスチャ</translation>
    </message>
    <message>
        <source>Dimples in faceted patches on the selected faces</source>
        <translation>選択した面上のファセット状パッチのディンプル</translation>
    </message>
</context>
<context>
    <name>PatchMill_Report</name>
    <message>
        <source>Report</source>
        <translation>レポート</translation>
    </message>
    <message>
        <source>Posts the job, and writes pictures and figures</source>
        <translation>ジョブを出力し、図と数値を書き出します</translation>
    </message>
</context>
<context>
    <name>PatchMill_Simulate</name>
    <message>
        <source>Simulate marks</source>
        <translation>切削痕シミュレーション</translation>
    </message>
    <message>
        <source>Shows the relief that the tool will leave</source>
        <translation>工具が残すレリーフを表示します</translation>
    </message>
</context>
</TS>
