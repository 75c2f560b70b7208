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
    <message>
        <source>Largest on the tool in a turn, in N; 0: no limit</source>
        <translation>1回転中に工具に働く最大の力、N単位;0:制限なし</translation>
    </message>
    <message>
        <source>Power at the tool&apos;s edges, in W; 0: no limit</source>
        <translation>切れ刃での動力、W単位;0:制限なし</translation>
    </message>
    <message>
        <source>Mean chip thickness; 0: no limit</source>
        <translation>平均切りくず厚さ;0:制限なし</translation>
    </message>
    <message>
        <source>k_c1.1 of the stock: cutting force on a chip 1 mm thick and 1 mm wide, in N</source>
        <translation>素材のk_c1.1:厚さ1 mm、幅1 mmの切りくずに対する切削力、N単位</translation>
    </message>
    <message>
        <source>m_c of the stock: how thin chips resist more</source>
        <translation>素材のm_c:薄い切りくずほど大きくなる抵抗の指数</translation>
    </message>
    <message>
        <source>Normal to the cutting surface, of the cutting force</source>
        <translation>切れ刃面に垂直な力の、切削力に対する比</translation>
    </message>
    <message>
        <source>On the tool in a turn, in N; 0: no limit of the load</source>
        <translation>1回転中に工具に働く力、N単位;0:負荷の制限なし</translation>
    </message>
    <message>
        <source>At the tool&apos;s edges, in W; 0: no limit of the load</source>
        <translation>切れ刃での動力、W単位;0:負荷の制限なし</translation>
    </message>
    <message>
        <source>Mean chip thickness, in mm; 0: no limit of the load</source>
        <translation>平均切りくず厚さ、mm単位;0:負荷の制限なし</translation>
    </message>
    <message>
        <source>Mill patch by patch along helices, in rows of the lattice, or all round a cylinder along one thread while a rotary table turns it</source>
        <translation>パッチごとにらせん状に、格子の行ごとに、または回転テーブルが回す円柱の全周を一本のねじ線に沿って加工</translation>
    </message>
    <message>
        <source>Projected: spacing kept as seen along the projection; on surface: kept along the faces; ball: a lattice that is a sphere&apos;s own</source>
        <translation>投影: 投影方向から見て間隔を保つ; 面上: 面に沿って間隔を保つ; 球: 球に固有の格子</translation>
    </message>
    <message>
        <source>Lattice of a ball: icosahedral, most even; along a Fibonacci spiral; or in rings about its pole</source>
        <translation>球の格子: 最も均一な正二十面体型; フィボナッチらせんに沿う; 極のまわりの輪</translation>
    </message>
    <message>
        <source>Dimples on the whole ball; 0: by the spacing</source>
        <translation>球全体のディンプル数; 0: 間隔による</translation>
    </message>
    <message>
        <source>One: dimples no steeper than the limit; two: those of the half that looks to the tool, the others after the ball was turned over</source>
        <translation>1: 制限より急でないディンプル; 2: 工具側の半球のディンプル、残りは球を裏返した後</translation>
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
    <message>
        <source>--program-number={}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD posts what has ToolController and Active: take it out of the job.</source>
        <translation>FreeCAD は ToolController と Active を持つものをポストします。ジョブから外してください。</translation>
    </message>
    <message>
        <source>FreeCAD refused it: check its job, base faces and tool.</source>
        <translation>FreeCAD が拒否しました。ジョブ、面、工具を確かめてください。</translation>
    </message>
    <message>
        <source>FreeCAD takes a tool controller of number 0 for none: give {} another.</source>
        <translation>FreeCAD は番号 0 のツールコントローラーをないものとして扱います。{} に別の番号を付けてください。</translation>
    </message>
    <message>
        <source>FreeCAD would read it otherwise: write words of a letter and a number, each letter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD&apos;s paths are in millimetres: take it out.</source>
        <translation>FreeCAD の経路はミリメートルです。この語を取り除いてください。</translation>
    </message>
    <message>
        <source>TCP is on</source>
        <translation>TCP が有効</translation>
    </message>
    <message>
        <source>TCP is {} in line {}</source>
        <translation>{1} 行目で TCP は {0}</translation>
    </message>
    <message>
        <source>a ball end mill alone can be seen so: choose one.</source>
        <translation>このように表示できるのはボールエンドミルだけです。ボールエンドミルを選んでください。</translation>
    </message>
    <message>
        <source>a ball of radius {} mm leaves untouched material between marks so far apart: choose less, a smaller cross-feed or a larger ball.</source>
        <translation>半径 {} mm のボールでは、これほど離れた痕の間に削り残しが出ます。小さくするか、ピックフィードを小さくするか、大きいボールを選んでください。</translation>
    </message>
    <message>
        <source>a curved base needs {} of each, a flat one none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a cut needs a feed greater than zero: give it one here.</source>
        <translation>切削には 0 より大きい送りが必要です。ここに指定してください。</translation>
    </message>
    <message>
        <source>a drilling cycle goes from R down to Z.</source>
        <translation>穴あけサイクルは R から Z へ下がります。</translation>
    </message>
    <message>
        <source>a grid needs at least one cell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a lead of {} mm in line {}</source>
        <translation>{1} 行目のリード {0} mm</translation>
    </message>
    <message>
        <source>a live session cuts scanning lines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a locked path needs no fitting.</source>
        <translation>主軸同期の経路に調整は要りません。</translation>
    </message>
    <message>
        <source>a loop of {} points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a move turns the spindle forward.</source>
        <translation>移動は主軸を正方向に回します。</translation>
    </message>
    <message>
        <source>a move without feed</source>
        <translation>送りのない移動</translation>
    </message>
    <message>
        <source>a paced path needs two dimples at least: see the counts of those left out, and change the faces, the limits or the tool axis.</source>
        <translation>歩調を合わせた経路にはディンプルが二つ以上必要です。除かれた数を見て、面、制限または工具軸を変えてください。</translation>
    </message>
    <message>
        <source>a patch of side {} mm would have {} laps: choose a larger cross-feed.</source>
        <translation>一辺 {} mm のパッチは {} 周になります。ピックフィードを大きくしてください。</translation>
    </message>
    <message>
        <source>a patch would have {} marks: choose a larger feed per tooth.</source>
        <translation>一つのパッチに痕が {} 個できます。一刃送りを大きくしてください。</translation>
    </message>
    <message>
        <source>a path in FreeCAD needs one G or M word here.</source>
        <translation>FreeCAD の経路ではここに G または M の語が一つ必要です。</translation>
    </message>
    <message>
        <source>a peck greater than zero is needed.</source>
        <translation>ペック量は 0 より大きくしてください。</translation>
    </message>
    <message>
        <source>a recording has its machine in it: leave it out.</source>
        <translation>記録には機械が含まれています。省いてください。</translation>
    </message>
    <message>
        <source>a rotary axis turns in a G33 block, which {} cannot: keep one tool axis for the whole texture, or use feed per move.</source>
        <translation>G33 ブロックで回転軸が動きますが、{} にはできません。テクスチャ全体で工具軸を一定にするか、移動ごとの送りを使ってください。</translation>
    </message>
    <message>
        <source>a section goes upward from 0 or more, has radii of 0 or more, and all are at most 1e6 mm.</source>
        <translation>区分は 0 以上から上へ向かい、半径は 0 以上で、すべて 1e6 mm 以下です。</translation>
    </message>
    <message>
        <source>a shape without faces</source>
        <translation>面のない形状</translation>
    </message>
    <message>
        <source>a spindle-locked move needs a way of the programmed point: rotary axes alone cannot be locked.</source>
        <translation>主軸同期の移動にはプログラム点の移動が必要です。回転軸だけを同期させることはできません。</translation>
    </message>
    <message>
        <source>a spindle-locked move needs more turns than its corner roundings take.</source>
        <translation>主軸同期の移動には、コーナーの丸めより多い回転が必要です。</translation>
    </message>
    <message>
        <source>a stop would end the spindle&apos;s lock: post each patch as a file of its own (patches=1).</source>
        <translation>停止すると主軸の同期が終わります。パッチごとに別のファイルへポストしてください (patches=1)。</translation>
    </message>
    <message>
        <source>a texture on the surface begins there, and no face can be cut there: move it.</source>
        <translation>面上のテクスチャはそこから始まりますが、そこで削れる面がありません。移動してください。</translation>
    </message>
    <message>
        <source>a texture path</source>
        <translation>テクスチャの経路</translation>
    </message>
    <message>
        <source>a texture&apos;s feed is its timing and its axis sets the phase: choose another operation.</source>
        <translation>テクスチャの送りはタイミングで、軸は位相を決めます。別の操作を選んでください。</translation>
    </message>
    <message>
        <source>a timed move needs more than no turns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a vertex at infinity</source>
        <translation>無限遠の頂点</translation>
    </message>
    <message>
        <source>about {} dimples are more than the limit of {}: choose a larger spacing or a smaller area.</source>
        <translation>約 {} 個のディンプルは上限 {} を超えます。間隔を大きくするか、領域を小さくしてください。</translation>
    </message>
    <message>
        <source>about {} dimples are more than the limit of {}: choose a larger spacing or fewer faces.</source>
        <translation>約 {} 個のディンプルは上限 {} を超えます。間隔を大きくするか、面を減らしてください。</translation>
    </message>
    <message>
        <source>all that follows would be read by it: take it out of the preamble.</source>
        <translation>以降のすべてがそれに従って読まれます。プリアンブルから取り除いてください。</translation>
    </message>
    <message>
        <source>an arc needs its centre by I and J, in the XY plane.</source>
        <translation>円弧には XY 平面で I と J による中心が必要です。</translation>
    </message>
    <message>
        <source>an edge without a curve</source>
        <translation>曲線のない辺</translation>
    </message>
    <message>
        <source>an open shell, {} unmatched edges</source>
        <translation>開いたシェル、対のない辺 {} 本</translation>
    </message>
    <message>
        <source>an upright operation follows, and the machine&apos;s file does not say where the tool is clear of a turning table: give retract_mm there, or bring them back to zero in the operation that turns them.</source>
        <translation>次は工具が直立する操作ですが、機械ファイルには回るテーブルから工具が離れる位置がありません。retract_mm を指定するか、軸を回した操作の中で 0 に戻してください。</translation>
    </message>
    <message>
        <source>an upright shank would cut the overhang: put a DCM modifier with posture on {}.</source>
        <translation>直立したシャンクがオーバーハングを削ります。{} に姿勢つきの DCM 修飾を付けてください。</translation>
    </message>
    <message>
        <source>another operation leaves this, not its tool&apos;s length: end that one by G43 H{}.</source>
        <translation>別の操作が、自分の工具長ではなくこれを残します。その操作を G43 H{} で終えてください。</translation>
    </message>
    <message>
        <source>at most about {} million are made: give {} mm or more.</source>
        <translation>作られるのは最大で約 {} 百万です。{} mm 以上を指定してください。</translation>
    </message>
    <message>
        <source>at this spacing it takes dimples of {} mm, wider than the ball: choose a larger ball or a smaller spacing.</source>
        <translation>この間隔では直径 {} mm のディンプルが必要で、ボールより広くなります。大きいボールか小さい間隔を選んでください。</translation>
    </message>
    <message>
        <source>axis {} would leave its limits by {} mm.</source>
        <translation>軸 {} が限界を {} mm 超えます。</translation>
    </message>
    <message>
        <source>byte {} is no UTF-8: save the file as UTF-8.</source>
        <translation>{} バイト目が UTF-8 ではありません。UTF-8 で保存してください。</translation>
    </message>
    <message>
        <source>byte {} is zero, as in UTF-16 and in what is no text: save the file as plain text.</source>
        <translation>{} バイト目が 0 です。UTF-16 かテキスト以外のものです。プレーンテキストで保存してください。</translation>
    </message>
    <message>
        <source>choose 3, 4 or 6: other regular polygons do not cover a face.</source>
        <translation>3、4、6 のどれかを選んでください。他の正多角形では面を覆えません。</translation>
    </message>
    <message>
        <source>choose a DCM modifier, or none.</source>
        <translation>DCM 修飾を選ぶか、なしにしてください。</translation>
    </message>
    <message>
        <source>choose a texture, copy milling or a DCM modifier.</source>
        <translation>テクスチャ、倣い加工または DCM 修飾を選んでください。</translation>
    </message>
    <message>
        <source>choose a work offset in the job&apos;s setup, such as G54.</source>
        <translation>ジョブの設定で G54 などのワークオフセットを選んでください。</translation>
    </message>
    <message>
        <source>choose an operation or a dressup of a job.</source>
        <translation>ジョブの操作またはドレスアップを選んでください。</translation>
    </message>
    <message>
        <source>choose faces that have an inside.</source>
        <translation>内側のある面を選んでください。</translation>
    </message>
    <message>
        <source>choose it so that each axis gets 1 to 32,768 voxels.</source>
        <translation>各軸が 1 から 32,768 ボクセルになるように選んでください。</translation>
    </message>
    <message>
        <source>choose square or staggered.</source>
        <translation>正方または千鳥を選んでください。</translation>
    </message>
    <message>
        <source>choose the coolant in the operations that want it: their Coolant says Flood or Mist.</source>
        <translation>必要な操作でクーラントを選んでください。Coolant を Flood または Mist にします。</translation>
    </message>
    <message>
        <source>corner {} of {} vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>count from 0, the first dimple.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dimples {} and {} are at one place on the program&apos;s decimals.</source>
        <translation>ディンプル {} と {} はプログラムの小数桁では同じ位置になります。</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>empty or infinite</source>
        <translation>空または無限</translation>
    </message>
    <message>
        <source>enlarge it: there would be more than ten million passes.</source>
        <translation>大きくしてください。パスが一千万を超えます。</translation>
    </message>
    <message>
        <source>enlarge the tolerance.</source>
        <translation>許容差を大きくしてください。</translation>
    </message>
    <message>
        <source>every lattice point was left out ({}): {}.</source>
        <translation>格子点がすべて除かれました ({})。{}。</translation>
    </message>
    <message>
        <source>every lattice point was left out: see the counts by reason, and change the faces, the limits or the tool axis.</source>
        <translation>格子点がすべて除かれました。理由ごとの数を見て、面、制限または工具軸を変えてください。</translation>
    </message>
    <message>
        <source>every mark was left out: see the counts by reason, and change the faces, the limits or the tool axis.</source>
        <translation>痕がすべて除かれました。理由ごとの数を見て、面、制限または工具軸を変えてください。</translation>
    </message>
    <message>
        <source>explicit steps are stable up to r = {}: use at most {} s, or allow sub-steps.</source>
        <translation>陽解法は r = {} まで安定です。{} s 以下にするか、分割ステップを許してください。</translation>
    </message>
    <message>
        <source>faces without area</source>
        <translation>面積のない面</translation>
    </message>
    <message>
        <source>give 0 &lt;= from &lt; to and diameters of 0 or more.</source>
        <translation>0 &lt;= 始点 &lt; 終点 とし、直径を 0 以上にしてください。</translation>
    </message>
    <message>
        <source>give 0 or at least FeedAtSkin.</source>
        <translation>0 か、素材表面での送り以上を指定してください。</translation>
    </message>
    <message>
        <source>give 0 or more.</source>
        <translation>0 以上を指定してください。</translation>
    </message>
    <message>
        <source>give 0 to {} decimals.</source>
        <translation>小数桁を 0 から {} で指定してください。</translation>
    </message>
    <message>
        <source>give 0, 1 or 2 for x, y or z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give 1 or more.</source>
        <translation>1 以上を指定してください。</translation>
    </message>
    <message>
        <source>give 255 at most.</source>
        <translation>255 以下を指定してください。</translation>
    </message>
    <message>
        <source>give A, B or C.</source>
        <translation>A、B、C のどれかを指定してください。</translation>
    </message>
    <message>
        <source>give a closed solid; mend the gaps or the flipped triangles.</source>
        <translation>閉じたソリッドを指定してください。隙間や裏返った三角形を直します。</translation>
    </message>
    <message>
        <source>give a depth greater than zero.</source>
        <translation>0 より大きい深さを指定してください。</translation>
    </message>
    <message>
        <source>give a direction: finite, and not zero.</source>
        <translation>方向を指定してください。有限で 0 でないものです。</translation>
    </message>
    <message>
        <source>give a factor greater than zero.</source>
        <translation>0 より大きい係数を指定してください。</translation>
    </message>
    <message>
        <source>give a finite vector other than zero; a voxel model has none inside the part.</source>
        <translation>0 でない有限のベクトルを指定してください。ボクセルモデルは部品の内側にはありません。</translation>
    </message>
    <message>
        <source>give a finite vector that is not zero.</source>
        <translation>0 でない有限のベクトルを指定してください。</translation>
    </message>
    <message>
        <source>give a function of positions and normals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give a height above 0 and up to the ball&apos;s radius, {} mm.</source>
        <translation>0 より大きくボール半径 {} mm 以下の高さを指定してください。</translation>
    </message>
    <message>
        <source>give a length greater than zero.</source>
        <translation>0 より大きい長さを指定してください。</translation>
    </message>
    <message>
        <source>give a name, a factor on the feed, and a depth in mm or the name of a solid, such as &apos;skin 0.6 1.5&apos;.</source>
        <translation>名前、送りの係数、深さ [mm] またはソリッドの名前を指定してください。例: &apos;skin 0.6 1.5&apos;。</translation>
    </message>
    <message>
        <source>give a number of decimals, such as 3.</source>
        <translation>3 などの小数桁数を指定してください。</translation>
    </message>
    <message>
        <source>give a number.</source>
        <translation>数を指定してください。</translation>
    </message>
    <message>
        <source>give a path of this texture&apos;s plan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give a path whose moves are all timed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give a positive jerk in mm/s³, or leave it out for none.</source>
        <translation>正の躍度 [mm/s³] を指定するか、ない場合は省いてください。</translation>
    </message>
    <message>
        <source>give a shape with faces.</source>
        <translation>面のある形状を指定してください。</translation>
    </message>
    <message>
        <source>give a size greater than zero.</source>
        <translation>0 より大きい大きさを指定してください。</translation>
    </message>
    <message>
        <source>give a solid whose surface faces outwards.</source>
        <translation>表面が外を向いたソリッドを指定してください。</translation>
    </message>
    <message>
        <source>give a solid with a tessellated surface.</source>
        <translation>表面がメッシュになるソリッドを指定してください。</translation>
    </message>
    <message>
        <source>give a stock larger than the part, or smaller voxels.</source>
        <translation>部品より大きい素材か、小さいボクセルを指定してください。</translation>
    </message>
    <message>
        <source>give a stock with length, width and height.</source>
        <translation>長さ、幅、高さのある素材を指定してください。</translation>
    </message>
    <message>
        <source>give a tessellated surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give a texture of the job.</source>
        <translation>ジョブのテクスチャを指定してください。</translation>
    </message>
    <message>
        <source>give a value from 0 to 90 degrees.</source>
        <translation>0 から 90 度の値を指定してください。</translation>
    </message>
    <message>
        <source>give a vector other than zero.</source>
        <translation>0 でないベクトルを指定してください。</translation>
    </message>
    <message>
        <source>give a whole multiple of {} turn, so that a flute is at the contact point again.</source>
        <translation>{} 回転の整数倍を指定してください。刃が再び接触点に来ます。</translation>
    </message>
    <message>
        <source>give a whole number, from 1.</source>
        <translation>1 以上の整数を指定してください。</translation>
    </message>
    <message>
        <source>give an angle above 0° and up to 90°.</source>
        <translation>0° より大きく 90° 以下の角度を指定してください。</translation>
    </message>
    <message>
        <source>give an area with finite corners.</source>
        <translation>有限の角をもつ領域を指定してください。</translation>
    </message>
    <message>
        <source>give an operation of PatchMill.</source>
        <translation>PatchMill の操作を指定してください。</translation>
    </message>
    <message>
        <source>give at least 0 and less than {} degrees.</source>
        <translation>0 以上 {} 度未満を指定してください。</translation>
    </message>
    <message>
        <source>give at least the lower feed.</source>
        <translation>下限の送り以上を指定してください。</translation>
    </message>
    <message>
        <source>give at least the safe height, {} mm.</source>
        <translation>安全高さ {} mm 以上を指定してください。</translation>
    </message>
    <message>
        <source>give closed loops of at least three finite points.</source>
        <translation>有限の点が三つ以上ある閉曲線を指定してください。</translation>
    </message>
    <message>
        <source>give each axis its own.</source>
        <translation>軸ごとに別のものを指定してください。</translation>
    </message>
    <message>
        <source>give either the feed per tooth or the ridge height.</source>
        <translation>一刃送りか山の高さのどちらかを指定してください。</translation>
    </message>
    <message>
        <source>give finite ((x, y) least, (x, y) greatest) in mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give finite numbers.</source>
        <translation>有限の数を指定してください。</translation>
    </message>
    <message>
        <source>give finite rows (time, x, y, z, spindle azimuth).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give finite vertices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give four numbers: from, to, two diameters.</source>
        <translation>四つの数を指定してください。始点、終点、二つの直径です。</translation>
    </message>
    <message>
        <source>give how many a file has at most, or 0.</source>
        <translation>一つのファイルの最大数か 0 を指定してください。</translation>
    </message>
    <message>
        <source>give it.</source>
        <translation>指定してください。</translation>
    </message>
    <message>
        <source>give more than 0 and at most {} degrees.</source>
        <translation>0 より大きく {} 度以下を指定してください。</translation>
    </message>
    <message>
        <source>give more than zero and less than the part&apos;s width.</source>
        <translation>0 より大きく部品の幅より小さくしてください。</translation>
    </message>
    <message>
        <source>give more than zero and no more than FeedAtSkin, {} mm/min.</source>
        <translation>0 より大きく、素材表面での送り {} mm/min 以下にしてください。</translation>
    </message>
    <message>
        <source>give no less than FirstPatch, {}.</source>
        <translation>最初のパッチ {} 以上を指定してください。</translation>
    </message>
    <message>
        <source>give numbers of zero or more.</source>
        <translation>0 以上の数を指定してください。</translation>
    </message>
    <message>
        <source>give one for each flute, or none.</source>
        <translation>刃ごとに一つ指定するか、なしにしてください。</translation>
    </message>
    <message>
        <source>give one for each of the {} dimples.</source>
        <translation>{} 個のディンプルごとに一つ指定してください。</translation>
    </message>
    <message>
        <source>give one for each of the {} {}.</source>
        <translation>{} 個の {} ごとに一つ指定してください。</translation>
    </message>
    <message>
        <source>give one for each text.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give one for the start and one per move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give one for the stock and one for each material.</source>
        <translation>素材に一つ、材料ごとに一つ指定してください。</translation>
    </message>
    <message>
        <source>give one greater than zero.</source>
        <translation>0 より大きいものを指定してください。</translation>
    </message>
    <message>
        <source>give one of path, program and samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give one of the lattice&apos;s {} steps.</source>
        <translation>格子の {} 通りのステップの一つを指定してください。</translation>
    </message>
    <message>
        <source>give one of: {}.</source>
        <translation>次のどれかを指定してください。{}。</translation>
    </message>
    <message>
        <source>give one role and one value per field for each of the grid&apos;s {} cells.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give one value for each pixel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give the least corner first.</source>
        <translation>小さい方の角を先に指定してください。</translation>
    </message>
    <message>
        <source>give the least corner first; all sides must be longer than zero.</source>
        <translation>小さい方の角を先に指定してください。辺はすべて 0 より長くします。</translation>
    </message>
    <message>
        <source>give the lower limit first.</source>
        <translation>下限を先に指定してください。</translation>
    </message>
    <message>
        <source>give the name of a post-processor.</source>
        <translation>ポストプロセッサの名前を指定してください。</translation>
    </message>
    <message>
        <source>give three finite numbers.</source>
        <translation>三つの有限の数を指定してください。</translation>
    </message>
    <message>
        <source>give triangles whose corners are vertices of the mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>give two different finite corners.</source>
        <translation>異なる二つの有限の角を指定してください。</translation>
    </message>
    <message>
        <source>give two rotary axes at most.</source>
        <translation>回転軸は二つまでにしてください。</translation>
    </message>
    <message>
        <source>give two vectors that are not parallel.</source>
        <translation>平行でない二つのベクトルを指定してください。</translation>
    </message>
    <message>
        <source>give values from 0 to 1.</source>
        <translation>0 から 1 の値を指定してください。</translation>
    </message>
    <message>
        <source>give whole numbers of rpm greater than zero.</source>
        <translation>0 より大きい整数の回転数 [rpm] を指定してください。</translation>
    </message>
    <message>
        <source>give zero or more.</source>
        <translation>0 以上を指定してください。</translation>
    </message>
    <message>
        <source>give {} mm or more.</source>
        <translation>{} mm 以上を指定してください。</translation>
    </message>
    <message>
        <source>give {} more than zero.</source>
        <translation>{} は 0 より大きくしてください。</translation>
    </message>
    <message>
        <source>give {} the width of its flat tip, more than 0.</source>
        <translation>{} の平らな先端の幅を 0 より大きくしてください。</translation>
    </message>
    <message>
        <source>in the free form every flute leaves a mark: allow any.</source>
        <translation>自由形ではすべての刃が痕を残します。どの刃でもよいとしてください。</translation>
    </message>
    <message>
        <source>in the free form the phase follows from the feed: choose &apos;{}&apos;.</source>
        <translation>自由形では位相は送りで決まります。「{}」を選んでください。</translation>
    </message>
    <message>
        <source>invalid</source>
        <translation>無効</translation>
    </message>
    <message>
        <source>it belongs to no job: choose one that does.</source>
        <translation>どのジョブにも属していません。ジョブに属するものを選んでください。</translation>
    </message>
    <message>
        <source>it can be one of trivkins, {}: take a machine file of that kind and change it.</source>
        <translation>使えるのは trivkins、{} です。その種類の機械ファイルをもとに変えてください。</translation>
    </message>
    <message>
        <source>it cannot be read ({}): give another file.</source>
        <translation>読めません ({})。別のファイルを指定してください。</translation>
    </message>
    <message>
        <source>it cannot be read ({}): save it as PNG.</source>
        <translation>読めません ({})。PNG で保存してください。</translation>
    </message>
    <message>
        <source>it cannot be taken away ({}): change the folder&apos;s permissions.</source>
        <translation>削除できません ({})。フォルダーの権限を変えてください。</translation>
    </message>
    <message>
        <source>it cannot be with a tilted tool, whose moves are in inverse time: set Controls to Feed.</source>
        <translation>逆時間送りで動く傾いた工具とは併用できません。制御を送りにしてください。</translation>
    </message>
    <message>
        <source>it cannot be written ({}): give another file.</source>
        <translation>書き込めません ({})。別のファイルを指定してください。</translation>
    </message>
    <message>
        <source>it could not be written: make room or choose a folder.</source>
        <translation>書き込めませんでした。空きを作るか、別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>it does not keep {}{} of {}: use one of PatchMill&apos;s own posts.</source>
        <translation>{2} の {0}{1} が保たれません。PatchMill のポストを使ってください。</translation>
    </message>
    <message>
        <source>it does not take the arguments {}: change them, or use another post-processor.</source>
        <translation>引数 {} を受け付けません。変えるか、別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>it failed ({}): use another post-processor.</source>
        <translation>失敗しました ({})。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>it failed in a way that FreeCAD&apos;s report view tells.</source>
        <translation>失敗しました。FreeCAD のレポートビューに理由があります。</translation>
    </message>
    <message>
        <source>it has an error, so that nothing after it is computed: mend it.</source>
        <translation>エラーがあり、その後が計算されません。直してください。</translation>
    </message>
    <message>
        <source>it has more than {} bytes: give a smaller file.</source>
        <translation>{} バイトを超えています。小さいファイルを指定してください。</translation>
    </message>
    <message>
        <source>it has no moves: recompute it.</source>
        <translation>移動がありません。再計算してください。</translation>
    </message>
    <message>
        <source>it has no path: take it out of the job&apos;s operations.</source>
        <translation>経路がありません。ジョブの操作から外してください。</translation>
    </message>
    <message>
        <source>it has no posture.</source>
        <translation>姿勢がありません。</translation>
    </message>
    <message>
        <source>it has no rotary axes: choose a machine that has, or only Feed.</source>
        <translation>回転軸がありません。回転軸のある機械か、送りだけを選んでください。</translation>
    </message>
    <message>
        <source>it has no surface: repair the shape.</source>
        <translation>曲面がありません。形状を直してください。</translation>
    </message>
    <message>
        <source>it has no wires: choose sketches or wires.</source>
        <translation>ワイヤーがありません。スケッチかワイヤーを選んでください。</translation>
    </message>
    <message>
        <source>it includes itself.</source>
        <translation>自分自身を含んでいます。</translation>
    </message>
    <message>
        <source>it is a device or a pipe, not a file: give another one.</source>
        <translation>ファイルではなくデバイスかパイプです。別のものを指定してください。</translation>
    </message>
    <message>
        <source>it is a device or a pipe, not a file: name another one.</source>
        <translation>ファイルではなくデバイスかパイプです。別の名前にしてください。</translation>
    </message>
    <message>
        <source>it is empty: give the program of this job.</source>
        <translation>空です。このジョブのプログラムを指定してください。</translation>
    </message>
    <message>
        <source>it is gone: choose a face again.</source>
        <translation>なくなっています。面を選び直してください。</translation>
    </message>
    <message>
        <source>it is inside out, its faces look into it: reverse the shape, or make the solid again.</source>
        <translation>裏返っていて、面が内側を向いています。形状を反転するか、ソリッドを作り直してください。</translation>
    </message>
    <message>
        <source>it is nested too deeply.</source>
        <translation>入れ子が深すぎます。</translation>
    </message>
    <message>
        <source>it is no LinuxCNC configuration: it says nothing of axes.</source>
        <translation>LinuxCNC の設定ではありません。軸の記述がありません。</translation>
    </message>
    <message>
        <source>it is no work offset of a control: choose G54 to G59.3 in the job&apos;s setup.</source>
        <translation>制御装置のワークオフセットではありません。ジョブの設定で G54 から G59.3 を選んでください。</translation>
    </message>
    <message>
        <source>it is not in the job {}: choose faces of {}.</source>
        <translation>ジョブ {} にありません。{} の面を選んでください。</translation>
    </message>
    <message>
        <source>it is of an earlier posting, and would be run after these: take it away.</source>
        <translation>前のポストのもので、これらの後に実行されます。取り除いてください。</translation>
    </message>
    <message>
        <source>it is parallel to axis {}: two parallel rotary axes are one.</source>
        <translation>軸 {} と平行です。平行な二つの回転軸は一つと同じです。</translation>
    </message>
    <message>
        <source>it is switched off.</source>
        <translation>無効になっています。</translation>
    </message>
    <message>
        <source>it stands twice, and all would be milled twice at one place: name it once.</source>
        <translation>二度あり、すべてが同じ場所で二度削られます。一度にしてください。</translation>
    </message>
    <message>
        <source>it would change a texture&apos;s path, which is its timing: take it away.</source>
        <translation>テクスチャの経路を変えますが、経路はタイミングです。取り除いてください。</translation>
    </message>
    <message>
        <source>it would end the program, which the post does: take it out.</source>
        <translation>プログラムが終わりますが、それはポストが行います。取り除いてください。</translation>
    </message>
    <message>
        <source>it would have to turn at {} times its greatest velocity in move {}: smooth the tool axes, or {}.</source>
        <translation>移動 {1} で最大速度の {0} 倍で回ることになります。工具軸を滑らかにするか、{2}。</translation>
    </message>
    <message>
        <source>it would take {} GB of memory, and {} GB are free: {}</source>
        <translation>メモリーが {} GB 必要ですが、空きは {} GB です: {}</translation>
    </message>
    <message>
        <source>it would take {} GB: scale it down to {} million pixels, one for each dimple does.</source>
        <translation>{} GB 必要です。{} 百万画素に縮小してください。ディンプルごとに 1 画素で足ります。</translation>
    </message>
    <message>
        <source>it wrote nothing: use another post-processor.</source>
        <translation>何も書かれませんでした。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>its controller does not keep the tool tip: choose one with TCP.</source>
        <translation>制御装置が工具先端を保ちません。TCP のあるものを選んでください。</translation>
    </message>
    <message>
        <source>its ends are not on one circle, by {} mm: choose another operation.</source>
        <translation>両端が一つの円上になく、{} mm ずれています。別の操作を選んでください。</translation>
    </message>
    <message>
        <source>its feed is a timing, which must not change.</source>
        <translation>送りはタイミングなので変えられません。</translation>
    </message>
    <message>
        <source>its motion is not known: {}.</source>
        <translation>動きが分かりません。{}。</translation>
    </message>
    <message>
        <source>its start phase was found by a version that counted it anew in each program: mill a calibration patch anew.</source>
        <translation>開始位相は、プログラムごとに数え直す版で求めたものです。較正パッチを削り直してください。</translation>
    </message>
    <message>
        <source>its start phase was found with the controller &apos;{}&apos;, and it has &apos;{}&apos;: mill a calibration patch anew.</source>
        <translation>開始位相はツールコントローラー「{}」で求めましたが、今は「{}」です。較正パッチを削り直してください。</translation>
    </message>
    <message>
        <source>its tool is tilted already: choose an upright path.</source>
        <translation>工具がすでに傾いています。直立の経路を選んでください。</translation>
    </message>
    <message>
        <source>leave its feed alone: a texture&apos;s feed is its timing.</source>
        <translation>送りはそのままにしてください。テクスチャの送りはタイミングです。</translation>
    </message>
    <message>
        <source>legs can be fitted to stops only where the machine stops: use exact stop.</source>
        <translation>区間を停止に合わせられるのは機械が止まる所だけです。イグザクトストップを使ってください。</translation>
    </message>
    <message>
        <source>let the operation mill a face of the job&apos;s model.</source>
        <translation>ジョブのモデルの面を削る操作にしてください。</translation>
    </message>
    <message>
        <source>line {} begins at X{} Y{} Z{}</source>
        <translation>{} 行目は X{} Y{} Z{} から始まる</translation>
    </message>
    <message>
        <source>live, choose the whole model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lower limit above the upper one</source>
        <translation>下限が上限を超えている</translation>
    </message>
    <message>
        <source>make voxels about {} mm or raise the memory limit.</source>
        <translation>ボクセルを約 {} mm にするか、メモリーの上限を上げてください。</translation>
    </message>
    <message>
        <source>masks need dimples on a lattice: choose None.</source>
        <translation>マスクには格子上のディンプルが必要です。なしを選んでください。</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>ありません</translation>
    </message>
    <message>
        <source>move the part into the stock or enlarge it.</source>
        <translation>部品を素材の中に動かすか、素材を大きくしてください。</translation>
    </message>
    <message>
        <source>move the part into the stock or enlarge the stock.</source>
        <translation>部品を素材の中に動かすか、素材を大きくしてください。</translation>
    </message>
    <message>
        <source>name a machine file with rotary axes: they tilt the tool.</source>
        <translation>回転軸のある機械ファイルを指定してください。回転軸が工具を傾けます。</translation>
    </message>
    <message>
        <source>name the machine on which the patch was milled.</source>
        <translation>パッチを削った機械を指定してください。</translation>
    </message>
    <message>
        <source>no JSON</source>
        <translation>JSON ではない</translation>
    </message>
    <message>
        <source>no Resources/machines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no dimples</source>
        <translation>ディンプルがない</translation>
    </message>
    <message>
        <source>no direction at dimple {}</source>
        <translation>ディンプル {} に方向がない</translation>
    </message>
    <message>
        <source>no machine</source>
        <translation>機械がない</translation>
    </message>
    <message>
        <source>no operation, tool or work offset there has this word: take it out of the post.</source>
        <translation>そこにはこの語を持つ操作、工具、ワークオフセットがありません。ポストから取り除いてください。</translation>
    </message>
    <message>
        <source>no path</source>
        <translation>経路がない</translation>
    </message>
    <message>
        <source>no phase is wanted at this dimple.</source>
        <translation>このディンプルに位相は求められていません。</translation>
    </message>
    <message>
        <source>no phase is wanted there.</source>
        <translation>そこに位相は求められていません。</translation>
    </message>
    <message>
        <source>no place of the faces can be cut from this direction: choose another direction, a steeper limit or other faces.</source>
        <translation>この方向から削れる場所が面にありません。別の方向、急な制限、または別の面を選んでください。</translation>
    </message>
    <message>
        <source>no places</source>
        <translation>場所がない</translation>
    </message>
    <message>
        <source>no posture for dimple {}</source>
        <translation>ディンプル {} に姿勢がない</translation>
    </message>
    <message>
        <source>no shape</source>
        <translation>形状がない</translation>
    </message>
    <message>
        <source>no volume</source>
        <translation>体積がない</translation>
    </message>
    <message>
        <source>no way in</source>
        <translation>進入路がない</translation>
    </message>
    <message>
        <source>none of its moves end on the texture&apos;s dimples.</source>
        <translation>テクスチャのディンプルで終わる移動がありません。</translation>
    </message>
    <message>
        <source>none over the part</source>
        <translation>部品の上にない</translation>
    </message>
    <message>
        <source>not Scanning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not computed</source>
        <translation>未計算</translation>
    </message>
    <message>
        <source>not finite</source>
        <translation>有限でない</translation>
    </message>
    <message>
        <source>not in the program</source>
        <translation>プログラムにない</translation>
    </message>
    <message>
        <source>one tooth per dimple takes {} mm/s: turn the spindle at no more than {} rpm.</source>
        <translation>ディンプルごとに一刃では {} mm/s になります。主軸を {} rpm 以下にしてください。</translation>
    </message>
    <message>
        <source>only your own machine files can be taken away.</source>
        <translation>削除できるのは自分の機械ファイルだけです。</translation>
    </message>
    <message>
        <source>other K or F words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other K or F words in line {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other words G61 and G64</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plan one for each of the {} dimples.</source>
        <translation>{} 個のディンプルごとに一つ計画してください。</translation>
    </message>
    <message>
        <source>plan the postures of these dimples.</source>
        <translation>これらのディンプルの姿勢を計画してください。</translation>
    </message>
    <message>
        <source>post the operations of a job.</source>
        <translation>ジョブの操作をポストしてください。</translation>
    </message>
    <message>
        <source>programs are in ASCII letters: use no others.</source>
        <translation>プログラムは ASCII 文字です。他の文字は使わないでください。</translation>
    </message>
    <message>
        <source>recordings are cut with an upright tool only.</source>
        <translation>記録は直立した工具でだけ削れます。</translation>
    </message>
    <message>
        <source>repair the operation before posting.</source>
        <translation>ポストの前に操作を直してください。</translation>
    </message>
    <message>
        <source>repair the shape.</source>
        <translation>形状を直してください。</translation>
    </message>
    <message>
        <source>rotary axes</source>
        <translation>回転軸</translation>
    </message>
    <message>
        <source>rotary words</source>
        <translation>回転軸の語</translation>
    </message>
    <message>
        <source>rounded corners (G64)</source>
        <translation>丸めたコーナー (G64)</translation>
    </message>
    <message>
        <source>samples must be in order of time.</source>
        <translation>記録は時間の順に並べてください。</translation>
    </message>
    <message>
        <source>say which copy goes on.</source>
        <translation>続けるコピーを指定してください。</translation>
    </message>
    <message>
        <source>say which of the job&apos;s goes on.</source>
        <translation>ジョブのどれを続けるか指定してください。</translation>
    </message>
    <message>
        <source>select a face, not an edge or a vertex.</source>
        <translation>辺や頂点ではなく面を選択してください。</translation>
    </message>
    <message>
        <source>select at least one face.</source>
        <translation>面を少なくとも一つ選択してください。</translation>
    </message>
    <message>
        <source>set Flutes of {} to what the tool has; proposed: {}, as most ball end mills have.</source>
        <translation>{} の Flutes を工具の刃数にしてください。ボールエンドミルに多い {} を提案します。</translation>
    </message>
    <message>
        <source>set the feeds of its tool controller.</source>
        <translation>ツールコントローラーの送りを設定してください。</translation>
    </message>
    <message>
        <source>several motions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spindle-locked</source>
        <translation>主軸同期</translation>
    </message>
    <message>
        <source>take only the posture from the voxel model: a texture&apos;s feed is its timing.</source>
        <translation>ボクセルモデルからは姿勢だけを使ってください。テクスチャの送りはタイミングです。</translation>
    </message>
    <message>
        <source>textures are posted in millimetres.</source>
        <translation>テクスチャはミリメートルでポストします。</translation>
    </message>
    <message>
        <source>the angle between the flanks of {} is more than 0 and at most 120 degrees.</source>
        <translation>{} の側面のなす角は 0 より大きく 120 度以下です。</translation>
    </message>
    <message>
        <source>the control of the machine {} takes {}: give --precision={} and the same Decimals.</source>
        <translation>機械 {} の制御装置は {} 桁です。--precision={} と同じ小数桁を指定してください。</translation>
    </message>
    <message>
        <source>the direction is parallel to the texture&apos;s x axis: choose another one.</source>
        <translation>方向がテクスチャの x 軸と平行です。別の方向を選んでください。</translation>
    </message>
    <message>
        <source>the faces look to all sides alike: switch it off and give a direction.</source>
        <translation>面があらゆる側を同じように向いています。オフにして方向を指定してください。</translation>
    </message>
    <message>
        <source>the feed makes {} mm a tooth: give the same.</source>
        <translation>送りから一刃 {} mm になります。同じ値を指定してください。</translation>
    </message>
    <message>
        <source>the file is read-only: name another one.</source>
        <translation>ファイルは読み取り専用です。別の名前にしてください。</translation>
    </message>
    <message>
        <source>the flat bottom of {} is within its radius, {} mm.</source>
        <translation>{} の平らな底は半径 {} mm の内側です。</translation>
    </message>
    <message>
        <source>the folder cannot be made ({}): set PATCHMILL_MACHINES to another one.</source>
        <translation>フォルダーを作れません ({})。PATCHMILL_MACHINES を別のフォルダーにしてください。</translation>
    </message>
    <message>
        <source>the free form has its spindle speed from the feed per tooth.</source>
        <translation>自由形の回転数は一刃送りから決まります。</translation>
    </message>
    <message>
        <source>the free form has no lattice: choose Helix.</source>
        <translation>自由形に格子はありません。ヘリックスを選んでください。</translation>
    </message>
    <message>
        <source>the free form is milled as a whole: give {}.</source>
        <translation>自由形は全体として削ります。{} を指定してください。</translation>
    </message>
    <message>
        <source>the free form&apos;s marks overlap: choose so.</source>
        <translation>自由形の痕は重なります。そのように選んでください。</translation>
    </message>
    <message>
        <source>the installation is not complete.</source>
        <translation>インストールが完全ではありません。</translation>
    </message>
    <message>
        <source>the job has {}.</source>
        <translation>ジョブにあるのは {} です。</translation>
    </message>
    <message>
        <source>the job makes {} files: post them with post_files().</source>
        <translation>ジョブは {} 個のファイルになります。post_files() でポストしてください。</translation>
    </message>
    <message>
        <source>the limit is {} GB: take {} mm or more, or a smaller window.</source>
        <translation>上限は {} GB です。{} mm 以上にするか、窓を小さくしてください。</translation>
    </message>
    <message>
        <source>the machine file says that this controller cannot follow the spindle: use the feed-per-move strategy, or set the machine&apos;s spindle lock if it can.</source>
        <translation>機械ファイルでは、この制御装置は主軸に追従できません。移動ごとの送りの方式を使うか、できるなら機械の主軸同期を有効にしてください。</translation>
    </message>
    <message>
        <source>the machine goes up to {} mm/min.</source>
        <translation>機械の最大は {} mm/min です。</translation>
    </message>
    <message>
        <source>the machine {} has no TCP.</source>
        <translation>機械 {} に TCP はありません。</translation>
    </message>
    <message>
        <source>the machine {} has the control {}: use patchmill_{}, or choose another machine.</source>
        <translation>機械 {} の制御装置は {} です。patchmill_{} を使うか、別の機械を選んでください。</translation>
    </message>
    <message>
        <source>the machine {} says that its controller cannot follow the spindle: use feed per move or constant feed.</source>
        <translation>機械 {} の制御装置は主軸に追従できません。移動ごとの送りか一定送りを使ってください。</translation>
    </message>
    <message>
        <source>the mesh is not closed: repair it, or take it out of the job.</source>
        <translation>メッシュが閉じていません。直すか、ジョブから外してください。</translation>
    </message>
    <message>
        <source>the net would have {} nodes, more than the limit of {}: choose a larger spacing or a smaller area.</source>
        <translation>ネットの節点は {} 個になり、上限 {} を超えます。間隔を大きくするか、領域を小さくしてください。</translation>
    </message>
    <message>
        <source>the next operation with {} would find the spindle so: end this one by M{}.</source>
        <translation>{} の次の操作で主軸がこの状態になります。この操作を M{} で終えてください。</translation>
    </message>
    <message>
        <source>the operation begins at X{} Y{} Z{}: use another post-processor.</source>
        <translation>操作は X{} Y{} Z{} から始まります。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>the operation has F {} there: use another post-processor.</source>
        <translation>操作ではそこが F {} です。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>the operation has another one there: use another post-processor.</source>
        <translation>操作ではそこが違います。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>the operation has no such word: use another post-processor.</source>
        <translation>操作にそのような語はありません。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>the operation has {} there: use another post-processor.</source>
        <translation>操作ではそこが {} です。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>the operation has {}: use another post-processor.</source>
        <translation>操作には {} があります。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>the operation is milled with TCP {}: use another post-processor.</source>
        <translation>操作は TCP {} で削ります。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>the operation under it is gone: delete the dressup.</source>
        <translation>元の操作がなくなっています。ドレスアップを削除してください。</translation>
    </message>
    <message>
        <source>the patch has no two passes at a cross-feed of {} mm: choose a longer side.</source>
        <translation>ピックフィード {} mm ではパッチに二つのパスが入りません。辺を長くしてください。</translation>
    </message>
    <message>
        <source>the patch has {}.</source>
        <translation>パッチにあるのは {} です。</translation>
    </message>
    <message>
        <source>the path ends a move on a dimple that the plan does not cut.</source>
        <translation>計画で削らないディンプルで終わる移動があります。</translation>
    </message>
    <message>
        <source>the path has no timed move before its first dimple that could be lengthened.</source>
        <translation>最初のディンプルの前に、延ばせる時間つきの移動がありません。</translation>
    </message>
    <message>
        <source>the path is not of constant feed {} mm/s.</source>
        <translation>経路は一定送り {} mm/s ではありません。</translation>
    </message>
    <message>
        <source>the path would take {} interpolation periods: too many to follow one by one.</source>
        <translation>経路は補間周期 {} 回になり、一つずつ追うには多すぎます。</translation>
    </message>
    <message>
        <source>the post leaves TCP on for what comes after it: end the operation by {}.</source>
        <translation>ポストが TCP を有効のまま残します。操作を {} で終えてください。</translation>
    </message>
    <message>
        <source>the post leaves it on for {}, whose coolant is None: end the operation by M9.</source>
        <translation>クーラントなしの {} にもクーラントが残ります。操作を M9 で終えてください。</translation>
    </message>
    <message>
        <source>the post leaves it on for {}: end the operation by {}.</source>
        <translation>{} まで残ります。操作を {} で終えてください。</translation>
    </message>
    <message>
        <source>the post writes {} decimals: give --precision={} or change Decimals.</source>
        <translation>ポストは小数 {} 桁で書きます。--precision={} を指定するか、小数桁を変えてください。</translation>
    </message>
    <message>
        <source>the post-processor changed the path: use another one.</source>
        <translation>ポストプロセッサが経路を変えました。別のものを使ってください。</translation>
    </message>
    <message>
        <source>the post-processor does not keep them: use patchmill_linuxcnc.</source>
        <translation>ポストプロセッサがそれらを保ちません。patchmill_linuxcnc を使ってください。</translation>
    </message>
    <message>
        <source>the posted text has a phase error of {} degrees in {} runs: post more decimals.</source>
        <translation>ポストしたプログラムは {1} 区間で位相誤差が {0} 度です。小数桁を増やしてください。</translation>
    </message>
    <message>
        <source>the posted text turns the spindle at {} rpm where {} is milled.</source>
        <translation>ポストしたプログラムでは、{1} を削る所で主軸が {0} rpm です。</translation>
    </message>
    <message>
        <source>the posted text turns the spindle at {} rpm {}.</source>
        <translation>ポストしたプログラムでは主軸が {} rpm です {}。</translation>
    </message>
    <message>
        <source>the posture did not converge (residual {}): try another size.</source>
        <translation>姿勢が収束しません (残差 {})。別の大きさを試してください。</translation>
    </message>
    <message>
        <source>the program does not call the tool&apos;s length: use another post-processor.</source>
        <translation>プログラムが工具長を呼び出しません。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>the program does not have it: use a post-processor that keeps it, or leave it out.</source>
        <translation>プログラムにありません。それを保つポストプロセッサを使うか、省いてください。</translation>
    </message>
    <message>
        <source>the program does not switch it on for {}: choose None, or another post-processor.</source>
        <translation>プログラムが {} で有効にしません。なしか、別のポストプロセッサを選んでください。</translation>
    </message>
    <message>
        <source>the program ends with it: use another post-processor.</source>
        <translation>プログラムがそのまま終わります。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>the program ends without it: use another post-processor.</source>
        <translation>プログラムがそれなしで終わります。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>the program has T{} in the spindle where {} is milled.</source>
        <translation>{1} を削る所で、プログラムの主軸の工具は T{0} です。</translation>
    </message>
    <message>
        <source>the program has it on where {} begins: end the operation before by M9.</source>
        <translation>{} の始まりで有効のままです。前の操作を M9 で終えてください。</translation>
    </message>
    <message>
        <source>the program has {} in force where {} begins: use another post-processor.</source>
        <translation>{1} の始まりで {0} が有効です。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>the recorded spindle turns the other way at {} s.</source>
        <translation>記録された主軸は {} s で逆に回っています。</translation>
    </message>
    <message>
        <source>the rotary axis next to the tool is parallel to the tool: it cannot tilt it. List the axes in chain order, from the work to the tool.</source>
        <translation>工具に最も近い回転軸が工具と平行で、傾けられません。ワークから工具への順に軸を並べてください。</translation>
    </message>
    <message>
        <source>the shape could not be read: repair it.</source>
        <translation>形状を読めませんでした。直してください。</translation>
    </message>
    <message>
        <source>the spindle must turn: Forward or Reverse.</source>
        <translation>主軸が回る必要があります。Forward か Reverse にしてください。</translation>
    </message>
    <message>
        <source>the strategy &apos;{}&apos; needs a machine file.</source>
        <translation>方式「{}」には機械ファイルが必要です。</translation>
    </message>
    <message>
        <source>the strategy has none to choose: leave it out.</source>
        <translation>この方式で選ぶものはありません。省いてください。</translation>
    </message>
    <message>
        <source>the table or head turns in line {} without it: use another post-processor.</source>
        <translation>{} 行目でそれなしにテーブルかヘッドが回ります。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>the texture belongs to no job with a stock and a model.</source>
        <translation>テクスチャが、素材とモデルのあるジョブに属していません。</translation>
    </message>
    <message>
        <source>the texture has nothing to look at.</source>
        <translation>テクスチャに見るものがありません。</translation>
    </message>
    <message>
        <source>the texture has the patches 1 to {}.</source>
        <translation>テクスチャのパッチは 1 から {} です。</translation>
    </message>
    <message>
        <source>the times of stops are known to a period only without a jerk limit.</source>
        <translation>停止の時間が一周期まで分かるのは、躍度の制限がないときだけです。</translation>
    </message>
    <message>
        <source>the tool is changed in line {} without it: use another post-processor.</source>
        <translation>{} 行目でそれなしに工具が替わります。別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>the tool must stand out further than its cutting end.</source>
        <translation>工具の突き出しは刃部より長くしてください。</translation>
    </message>
    <message>
        <source>the tool of {} needs a diameter greater than zero.</source>
        <translation>{} の工具には 0 より大きい直径が必要です。</translation>
    </message>
    <message>
        <source>the tool reaches Z {} mm between dimples: give a greater safe height.</source>
        <translation>ディンプルの間で工具が Z {} mm に達します。安全高さを大きくしてください。</translation>
    </message>
    <message>
        <source>the tool tip is at Z {} mm on dimple {}: give a greater safe height.</source>
        <translation>ディンプル {1} で工具先端が Z {0} mm になります。安全高さを大きくしてください。</translation>
    </message>
    <message>
        <source>the tool tip is at Z {} mm on mark {}: give a greater safe height.</source>
        <translation>痕 {1} で工具先端が Z {0} mm になります。安全高さを大きくしてください。</translation>
    </message>
    <message>
        <source>the upper corner must not lie below the lower one, nor too far from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the voxels lie from {} to {} mm.</source>
        <translation>ボクセルは {} から {} mm にあります。</translation>
    </message>
    <message>
        <source>there can be no such file ({}): give another name.</source>
        <translation>そのようなファイルは作れません ({})。別の名前にしてください。</translation>
    </message>
    <message>
        <source>there can be no such file: give another name.</source>
        <translation>そのようなファイルは作れません。別の名前にしてください。</translation>
    </message>
    <message>
        <source>there is no object &apos;{}&apos; with a shape: {}</source>
        <translation>形状のあるオブジェクト「{}」がありません: {}</translation>
    </message>
    <message>
        <source>there is no operation with a tool controller below it.</source>
        <translation>下にツールコントローラーのある操作がありません。</translation>
    </message>
    <message>
        <source>there is no such file: choose a picture.</source>
        <translation>そのファイルはありません。画像を選んでください。</translation>
    </message>
    <message>
        <source>there is no such machine file; there are: {}.</source>
        <translation>その機械ファイルはありません。あるのは {} です。</translation>
    </message>
    <message>
        <source>there is no such post-processor.</source>
        <translation>そのポストプロセッサはありません。</translation>
    </message>
    <message>
        <source>there must be a dimple to look at.</source>
        <translation>見るディンプルが必要です。</translation>
    </message>
    <message>
        <source>this FreeCAD posts the tool bit&apos;s: set both alike.</source>
        <translation>この FreeCAD は工具ビットの値をポストします。両方を同じにしてください。</translation>
    </message>
    <message>
        <source>this feed move is of no operation: take it out of the post.</source>
        <translation>この送りの移動はどの操作のものでもありません。ポストから取り除いてください。</translation>
    </message>
    <message>
        <source>this place is off the faces: choose one on them.</source>
        <translation>この場所は面の外です。面の上を選んでください。</translation>
    </message>
    <message>
        <source>this speed alone is judged.</source>
        <translation>判定するのはこの回転数だけです。</translation>
    </message>
    <message>
        <source>this word is not understood: choose another operation.</source>
        <translation>この語は分かりません。別の操作を選んでください。</translation>
    </message>
    <message>
        <source>tilted</source>
        <translation>傾いている</translation>
    </message>
    <message>
        <source>tools are changed by tool controllers: give the operation that of the tool, and take the word out.</source>
        <translation>工具はツールコントローラーで替えます。操作にその工具のものを設定し、この語を取り除いてください。</translation>
    </message>
    <message>
        <source>unknown in move {}</source>
        <translation>移動 {} で不明</translation>
    </message>
    <message>
        <source>use ASCII letters in labels and comments.</source>
        <translation>ラベルとコメントには ASCII 文字を使ってください。</translation>
    </message>
    <message>
        <source>use another post-processor.</source>
        <translation>別のポストプロセッサを使ってください。</translation>
    </message>
    <message>
        <source>use letters, digits, points, dashes and underscores for its name.</source>
        <translation>名前には英数字、ピリオド、ハイフン、下線を使ってください。</translation>
    </message>
    <message>
        <source>what a tool of kind &apos;{}&apos; leaves is not known: give 0.</source>
        <translation>種類「{}」の工具の削り残しは分かりません。0 を指定してください。</translation>
    </message>
    <message>
        <source>where that moves the tool is not known here: post the operation in a job of its own.</source>
        <translation>それで工具がどこへ動くか分かりません。操作を別のジョブでポストしてください。</translation>
    </message>
    <message>
        <source>without TCP a tilting head needs the length from its gauge point to the tip.</source>
        <translation>TCP なしの傾斜ヘッドには、基準点から先端までの長さが必要です。</translation>
    </message>
    <message>
        <source>work offsets are the job&apos;s: choose it in the job&apos;s setup, and take it out here.</source>
        <translation>ワークオフセットはジョブのものです。ジョブの設定で選び、ここから取り除いてください。</translation>
    </message>
    <message>
        <source>work offsets are the job&apos;s: choose it in the job&apos;s setup, and take the operation out.</source>
        <translation>ワークオフセットはジョブのものです。ジョブの設定で選び、操作を外してください。</translation>
    </message>
    <message>
        <source>{} Nothing is posted; {} Set PostGouging to post it all the same.</source>
        <translation>{} ポストしませんでした。{} それでもポストするには PostGouging を有効にしてください。</translation>
    </message>
    <message>
        <source>{} Set PostUnheld to post it all the same.</source>
        <translation>{} それでもポストするには PostUnheld を有効にしてください。</translation>
    </message>
    <message>
        <source>{} Tilt less.</source>
        <translation>{} 傾きを小さくしてください。</translation>
    </message>
    <message>
        <source>{} and {} have it, and are different tools: give one of them another number.</source>
        <translation>{} と {} が同じ番号ですが別の工具です。片方の番号を変えてください。</translation>
    </message>
    <message>
        <source>{} asks for {} {}: give that, or leave one of them empty.</source>
        <translation>{} から {} {} になります。それを指定するか、片方を空にしてください。</translation>
    </message>
    <message>
        <source>{} cannot read it: {}.</source>
        <translation>{} には読めません。{}。</translation>
    </message>
    <message>
        <source>{} dimples are more than the limit of {}: choose a larger spacing or fewer patches.</source>
        <translation>{} 個のディンプルは上限 {} を超えます。間隔を大きくするか、パッチを減らしてください。</translation>
    </message>
    <message>
        <source>{} does not know it.</source>
        <translation>{} の知らないものです。</translation>
    </message>
    <message>
        <source>{} has no block that follows the spindle: use feed per move or constant feed.</source>
        <translation>{} に主軸に追従するブロックはありません。移動ごとの送りか一定送りを使ってください。</translation>
    </message>
    <message>
        <source>{} has no such work offset: choose {} in the job&apos;s setup.</source>
        <translation>{} にそのワークオフセットはありません。ジョブの設定で {} を選んでください。</translation>
    </message>
    <message>
        <source>{} has no word for them: use constant feed.</source>
        <translation>{} にはその語がありません。一定送りを使ってください。</translation>
    </message>
    <message>
        <source>{} has taken its place in the job: choose that.</source>
        <translation>ジョブの中では {} に置き換わっています。そちらを選んでください。</translation>
    </message>
    <message>
        <source>{} in {}, {} in its tool bit</source>
        <translation>{1} では {0}、工具ビットでは {2}</translation>
    </message>
    <message>
        <source>{} is drawn there, and not milled there: set it to zero, and move the model.</source>
        <translation>{} は描かれた所では削られません。0 にしてモデルを動かしてください。</translation>
    </message>
    <message>
        <source>{} is milled with it: give the tool controller {} one.</source>
        <translation>{} の加工に使います。ツールコントローラー {} に設定してください。</translation>
    </message>
    <message>
        <source>{} is posted in millimetres.</source>
        <translation>{} はミリメートルでポストします。</translation>
    </message>
    <message>
        <source>{} is switched off: switch it on.</source>
        <translation>{} が無効です。有効にしてください。</translation>
    </message>
    <message>
        <source>{} marks are more than the limit of {}: choose a larger feed per tooth or fewer patches.</source>
        <translation>{} 個の痕は上限 {} を超えます。一刃送りを大きくするか、パッチを減らしてください。</translation>
    </message>
    <message>
        <source>{} mm for {} mm of stock</source>
        <translation>素材 {1} mm に対して {0} mm</translation>
    </message>
    <message>
        <source>{} mm outside the stock</source>
        <translation>素材の外に {} mm</translation>
    </message>
    <message>
        <source>{} mm radial, {} mm axial</source>
        <translation>半径方向 {} mm、軸方向 {} mm</translation>
    </message>
    <message>
        <source>{} mm, about {} million triangles</source>
        <translation>{} mm、三角形 約 {} 百万</translation>
    </message>
    <message>
        <source>{} mm, {} points a level</source>
        <translation>{} mm、各高さ {} 点</translation>
    </message>
    <message>
        <source>{} mm, {} voxels of box, about {} MiB of the {} MiB allowed</source>
        <translation>{0} mm、直方体 {1} ボクセル、許容 {3} MiB のうち約 {2} MiB</translation>
    </message>
    <message>
        <source>{} names {}, and a program is for one machine: choose the same, or post {} by itself.</source>
        <translation>{} は {} ですが、プログラムは一つの機械用です。同じにするか、{} を単独でポストしてください。</translation>
    </message>
    <message>
        <source>{} of {} dimples read back</source>
        <translation>{1} 個中 {0} 個のディンプルを読み戻した</translation>
    </message>
    <message>
        <source>{} of {} has {}: no smaller piece is made of it.</source>
        <translation>{1} の {0} は {2} です。これより小さくは分けません。</translation>
    </message>
    <message>
        <source>{} of {} moves read back</source>
        <translation>{1} 個中 {0} 個の移動を読み戻した</translation>
    </message>
    <message>
        <source>{} s, r = D dt / dx^2 = {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} sags and {} normals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} stops between patches</source>
        <translation>パッチ間の停止 {} 回</translation>
    </message>
    <message>
        <source>{} timed moves</source>
        <translation>時間つきの移動 {} 個</translation>
    </message>
    <message>
        <source>{} turns at {} rpm: take the word out, and give the operation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} turns take the tool {} mm, and dimple {} is {} mm away: give at least {} ExtraTurns.</source>
        <translation>{} 回転で工具は {} mm 進みますが、ディンプル {} まで {} mm あります。追加回転を {} 以上にしてください。</translation>
    </message>
    <message>
        <source>{} with a ball end mill: choose one.</source>
        <translation>{} にはボールエンドミルを使います。選んでください。</translation>
    </message>
    <message>
        <source>{} writes it as it is: use letters and digits, or one of PatchMill&apos;s own posts.</source>
        <translation>{} はそのまま書きます。英数字か PatchMill のポストを使ってください。</translation>
    </message>
    <message>
        <source>{} x {} with {} values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: repair the shape.</source>
        <translation>{}。形状を直してください。</translation>
    </message>
    <message>
        <source>{}: use one of PatchMill&apos;s own posts.</source>
        <translation>{}。PatchMill のポストを使ってください。</translation>
    </message>
    <message>
        <source>{}choose Without TCP.</source>
        <translation>{}TCP なしを選んでください。</translation>
    </message>
    <message>
        <source>Machine of LinuxCNC or FreeCAD</source>
        <translation>LinuxCNC または FreeCAD の機械</translation>
    </message>
    <message>
        <source>it is no machine file of FreeCAD: give another one.</source>
        <translation>FreeCAD の機械ファイルではありません。別のファイルを指定してください。</translation>
    </message>
    <message>
        <source>it says nothing of axes: give a machine file of FreeCAD.</source>
        <translation>軸の記述がありません。FreeCAD の機械ファイルを指定してください。</translation>
    </message>
    <message>
        <source>set the machine to metric units in FreeCAD&apos;s machine editor.</source>
        <translation>FreeCAD の機械エディターで機械をメートル単位にしてください。</translation>
    </message>
    <message>
        <source>Accelerations are not in the file: {} mm/s² was taken. Give those of the machine, from which follows what a texture&apos;s timing can be.</source>
        <translation>加速度はファイルにありません。{} mm/s² としました。テクスチャのタイミングはこれで決まるので、機械の値を指定してください。</translation>
    </message>
    <message>
        <source>Dimples cover {} % of the faces; left out on them: {}.</source>
        <translation>ディンプルは面の {} % を覆います。除いたもの: {}。</translation>
    </message>
    <message>
        <source>M428 is taken to switch TCP on, and M429 off: look into their subroutines.</source>
        <translation>M428 で TCP が有効、M429 で無効になるものとしました。サブルーチンを確かめてください。</translation>
    </message>
    <message>
        <source>No HAL file that was read joins an encoder to spindle.0.revs and spindle.0.index-enable: the spindle is taken for one that no move can follow.</source>
        <translation>読んだ HAL ファイルに、エンコーダーを spindle.0.revs と spindle.0.index-enable につなぐものがありません。主軸に追従できないものとします。</translation>
    </message>
    <message>
        <source>No HAL file that was read joins an encoder to spindle.0.revs and spindle.0.index-enable: the spindle is taken for one that no move can follow. Not read: {}.</source>
        <translation>読んだ HAL ファイルに、エンコーダーを spindle.0.revs と spindle.0.index-enable につなぐものがありません。主軸に追従できないものとします。読んでいないもの: {}。</translation>
    </message>
    <message>
        <source>No M428 and M429 are there to switch TCP: it is taken to have none.</source>
        <translation>TCP を切り替える M428 と M429 がありません。TCP はないものとします。</translation>
    </message>
    <message>
        <source>The control is taken to have no TCP: say so if it has.</source>
        <translation>制御装置に TCP はないものとしました。ある場合は設定してください。</translation>
    </message>
    <message>
        <source>The faces look to all sides alike: they are projected on along ({}, {}, {}).</source>
        <translation>面があらゆる側を同じように向いています。({}, {}, {}) の方向に投影します。</translation>
    </message>
    <message>
        <source>The lattice is laid in {} pieces.</source>
        <translation>格子は {} 片に分けて置かれます。</translation>
    </message>
    <message>
        <source>The safe height was raised to Z {} mm, above what is milled.</source>
        <translation>安全高さを、削る部分より上の Z {} mm に上げました。</translation>
    </message>
    <message>
        <source>The start phase is 0°: mill a calibration patch to find it.</source>
        <translation>開始位相は 0° です。較正パッチを削って求めてください。</translation>
    </message>
    <message>
        <source>The velocities differ ({} mm/s): the smallest was taken.</source>
        <translation>速度が異なります ({} mm/s)。最小のものを採りました。</translation>
    </message>
    <message>
        <source>Those of rotary axes are not either: {}°/s² was taken.</source>
        <translation>回転軸の加速度もありません。{}°/s² としました。</translation>
    </message>
    <message>
        <source>Where the rotary axis {} lies trivkins does not say: it was left out.</source>
        <translation>回転軸 {} の位置は trivkins では分からないため、省きました。</translation>
    </message>
    <message>
        <source>Where the tool is clear of the table is not known: give the retract height.</source>
        <translation>工具がテーブルから離れる位置が分かりません。退避高さを指定してください。</translation>
    </message>
    <message>
        <source>Whether the control can follow the spindle is not in the file: it is taken not to.</source>
        <translation>制御装置が主軸に追従できるかはファイルにありません。できないものとします。</translation>
    </message>
    <message>
        <source>Which of {} carries the other is not in the file: look at the axes.</source>
        <translation>{} のどちらが他方を載せるかはファイルにありません。軸を確かめてください。</translation>
    </message>
    <message>
        <source>[EMCMOT]SERVO_PERIOD is not given: 1 ms was taken, as LinuxCNC does.</source>
        <translation>[EMCMOT]SERVO_PERIOD がありません。LinuxCNC と同じく 1 ms としました。</translation>
    </message>
    <message>
        <source>an upright shank would cut the overhang: put a DCM modifier with posture on it.</source>
        <translation>直立したシャンクがオーバーハングを削ります。姿勢つきの DCM 修飾を付けてください。</translation>
    </message>
    <message>
        <source>the lines are further apart than the tool is wide: ridges stay between them.</source>
        <translation>行の間隔が工具の幅より広く、間に山が残ります。</translation>
    </message>
    <message>
        <source>{} differs ({} {}): the smallest was taken.</source>
        <translation>{} が異なります ({} {})。最小のものを採りました。</translation>
    </message>
    <message>
        <source>{} dimples go round the closed face, {} mm apart.</source>
        <translation>閉じた面を {} 個のディンプルが {} mm おきに一周します。</translation>
    </message>
    <message>
        <source>{} is set in no HAL file that was read: 0 was taken.</source>
        <translation>{} は読んだ HAL ファイルで設定されていません。0 としました。</translation>
    </message>
    <message>
        <source>{} lattice points are left out for others that are too near, where pieces or the two sides of a closed face meet.</source>
        <translation>片どうし、または閉じた面の両側が出会う所で、近すぎる格子点 {} 個を除きました。</translation>
    </message>
    <message>
        <source>{} lines in cavities are left out: no way from above.</source>
        <translation>くぼみの中の {} 行を除きました。上から届きません。</translation>
    </message>
    <message>
        <source>Take a smaller ball</source>
        <translation>より小さいボールを使う</translation>
    </message>
    <message>
        <source>{}, tool diameter {}</source>
        <translation>{}、工具直径 {}</translation>
    </message>
    <message>
        <source>{} dimples in one patch</source>
        <translation>一つのパッチにディンプル {} 個</translation>
    </message>
    <message>
        <source>A patch of side {} is larger than the faces ({} x {} mm): its side is made {}.</source>
        <translation>辺 {} のパッチは面 ({} x {} mm) より大きいため、辺を {} にします。</translation>
    </message>
    <message>
        <source>A patch of side {} is larger than the faces ({} x {} mm): its sides are made {} and {}.</source>
        <translation>辺 {} のパッチは面 ({} x {} mm) より大きいため、辺を {} と {} にします。</translation>
    </message>
    <message>
        <source>Force along the path</source>
        <translation>経路に沿った力</translation>
    </message>
    <message>
        <source>Power along the path</source>
        <translation>経路に沿った動力</translation>
    </message>
    <message>
        <source>Chip thickness along the path</source>
        <translation>経路に沿った切りくず厚さ</translation>
    </message>
    <message>
        <source>force [N]</source>
        <translation>力 [N]</translation>
    </message>
    <message>
        <source>power [W]</source>
        <translation>動力 [W]</translation>
    </message>
    <message>
        <source>chip thickness [µm]</source>
        <translation>切りくず厚さ [µm]</translation>
    </message>
    <message>
        <source>Largest force {} N ({} times the median), power {} W, chips {} µm thick</source>
        <translation>最大の力 {} N(中央値の{}倍)、動力 {} W、切りくず厚さ {} µm</translation>
    </message>
    <message>
        <source>Force limit</source>
        <translation>力の上限</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>負荷</translation>
    </message>
    <message>
        <source>Power limit</source>
        <translation>動力の上限</translation>
    </message>
    <message>
        <source>Chip limit</source>
        <translation>切りくず厚さの上限</translation>
    </message>
    <message>
        <source>Specific force</source>
        <translation>比切削抵抗</translation>
    </message>
    <message>
        <source>Force exponent</source>
        <translation>力の指数</translation>
    </message>
    <message>
        <source>Normal force</source>
        <translation>法線方向の力</translation>
    </message>
    <message>
        <source>The tool runs into the part beside the faces</source>
        <translation>工具が面の横で部品に当たります</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>ねじ線</translation>
    </message>
    <message>
        <source>The margin is not kept: the thread runs over both ends of the cylinder.</source>
        <translation>余白は守られません：ねじ線は円筒の両端を越えて進みます。</translation>
    </message>
    <message>
        <source>a cylinder turned by {} degrees</source>
        <translation>{} 度回転した円筒</translation>
    </message>
    <message>
        <source>a cylinder {} mm beside the axis</source>
        <translation>軸から {} mm 離れた円筒</translation>
    </message>
    <message>
        <source>a thread closes on itself only if the spindle leads the axes: choose Spindle-locked.</source>
        <translation>ねじ線は主軸が各軸を導くときだけ閉じます：「主軸同期」を選んでください。</translation>
    </message>
    <message>
        <source>a thread goes all the way round: choose all faces of a cylinder that has no holes.</source>
        <translation>ねじ線は全周を回ります：穴のない円筒のすべての面を選んでください。</translation>
    </message>
    <message>
        <source>a thread goes round a cylinder: choose a cylindrical face, or another Order.</source>
        <translation>ねじ線は円筒の周りを回ります：円筒面か、別の加工順を選んでください。</translation>
    </message>
    <message>
        <source>a thread goes round one: choose faces of one alone.</source>
        <translation>ねじ線は一つの円筒だけを回ります：一つの円筒の面だけを選んでください。</translation>
    </message>
    <message>
        <source>a thread is milled from outside: choose another Order.</source>
        <translation>ねじ線は外側から加工します：別の加工順を選んでください。</translation>
    </message>
    <message>
        <source>a thread needs a machine file with a rotary table, such as four-axis-mill.</source>
        <translation>ねじ線には four-axis-mill のような回転テーブルのある機械ファイルが必要です。</translation>
    </message>
    <message>
        <source>a thread needs one rotary table along X or Y and no other, as four-axis-mill has.</source>
        <translation>ねじ線には four-axis-mill のように X または Y に沿った回転テーブルが一つだけ必要です。</translation>
    </message>
    <message>
        <source>axis {} has limits and would have to wind from 0 to {} degrees: where it can, give null as its limits_degrees.</source>
        <translation>軸 {} には制限がありますが 0 から {} 度まで回る必要があります：回れる場合は limits_degrees に null を指定してください。</translation>
    </message>
    <message>
        <source>axis {} would go from {} to {} mm, beyond its limits.</source>
        <translation>軸 {} は {} から {} mm まで動き、制限を越えます。</translation>
    </message>
    <message>
        <source>axis {} would have to turn at {} degrees/s, and does at {}: give {} rpm or less.</source>
        <translation>軸 {} は {} 度/秒で回る必要がありますが {} までです：{} rpm 以下を指定してください。</translation>
    </message>
    <message>
        <source>give 0, for no limit, or more.</source>
        <translation>制限なしの 0、またはそれ以上を指定してください。</translation>
    </message>
    <message>
        <source>give a grid of at least 2 x 2 heights.</source>
        <translation>少なくとも 2 x 2 の高さの格子を指定してください。</translation>
    </message>
    <message>
        <source>give less than 90 degrees.</source>
        <translation>90 度未満を指定してください。</translation>
    </message>
    <message>
        <source>give the tool its number of flutes: the chip thickness follows from it.</source>
        <translation>工具に刃数を指定してください：切りくず厚さはそれで決まります。</translation>
    </message>
    <message>
        <source>how a tool of kind &apos;{}&apos; cuts is not known: choose another tool.</source>
        <translation>種類 &apos;{}&apos; の工具の切削のしかたは不明です：別の工具を選んでください。</translation>
    </message>
    <message>
        <source>it is to lie along the rotary axis {}: turn the job&apos;s model.</source>
        <translation>回転軸 {} に沿っている必要があります：ジョブのモデルを回してください。</translation>
    </message>
    <message>
        <source>its axis is to be the rotary axis {}, which goes through ({}, {}, {}) mm of the work: move the job&apos;s model, or tell the machine file&apos;s work_zero_mm.</source>
        <translation>その軸は回転軸 {} と一致している必要があり、回転軸は加工物の ({}, {}, {}) mm を通ります：ジョブのモデルを動かすか、機械ファイルの work_zero_mm を指定してください。</translation>
    </message>
    <message>
        <source>on a cylinder that turns the tool has a lead to the surface: choose Normal.</source>
        <translation>回転する円筒では工具は面に対してリード角を持ちます：「法線」を選んでください。</translation>
    </message>
    <message>
        <source>only a thread goes all round: use patchmill.simulate.</source>
        <translation>全周を回るのはねじ線だけです：patchmill.simulate を使ってください。</translation>
    </message>
    <message>
        <source>only {} go round the cylinder: choose a smaller one.</source>
        <translation>円筒の周りには {} 個しか並びません：小さくしてください。</translation>
    </message>
    <message>
        <source>several cylinders</source>
        <translation>複数の円筒</translation>
    </message>
    <message>
        <source>the tool&apos;s tip stands at Z {} mm: give more.</source>
        <translation>工具の先端は Z {} mm にあります：より大きな値を指定してください。</translation>
    </message>
    <message>
        <source>the feed would fall below {} mm/min: give more.</source>
        <translation>送り速度が {} mm/min を下回ります：より大きな値を指定してください。</translation>
    </message>
    <message>
        <source>Go on without saving what was changed?</source>
        <translation>変更を保存せずに続けますか?</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>table</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>head</source>
        <translation>ヘッド</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>先端</translation>
    </message>
    <message>
        <source>ball centre</source>
        <translation>ボール中心</translation>
    </message>
    <message>
        <source>index</source>
        <translation>インデックス</translation>
    </message>
    <message>
        <source>at speed</source>
        <translation>回転数到達時</translation>
    </message>
    <message>
        <source>{} of {}
move {} of {}{}
X {}  Y {}  Z {} {}
spindle {:.0f}°</source>
        <translation>{} / {}
移動 {} / {}{}
X {}  Y {}  Z {} {}
主軸 {:.0f}°</translation>
    </message>
    <message>
        <source>S{} takes {}, the phase off by up to {:.1f}°. None that holds is faster.</source>
        <translation>S{} では {}、位相のずれは最大 {:.1f}°。位相を保つものでこれより速いものはありません。</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Ball lattice</source>
        <translation>球の格子</translation>
    </message>
    <message>
        <source>Icosahedral</source>
        <translation>正二十面体型</translation>
    </message>
    <message>
        <source>Fibonacci</source>
        <translation>フィボナッチ</translation>
    </message>
    <message>
        <source>Rings</source>
        <translation>輪</translation>
    </message>
    <message>
        <source>Ball dimples</source>
        <translation>球のディンプル数</translation>
    </message>
    <message>
        <source>Ball setups</source>
        <translation>球の段取り</translation>
    </message>
    <message>
        <source>One</source>
        <translation>1</translation>
    </message>
    <message>
        <source>Two</source>
        <translation>2</translation>
    </message>
    <message>
        <source>Some dimples, {} mm wide, run into each other.</source>
        <translation>幅 {} mm のディンプルの一部が互いに重なります。</translation>
    </message>
    <message>
        <source>a ball&apos;s lattice is milled from outside: choose another Mapping.</source>
        <translation>球の格子は外側から加工します。別のマッピングを選んでください。</translation>
    </message>
    <message>
        <source>a ball&apos;s lattice is that of one: choose its faces alone.</source>
        <translation>球の格子は一つの球のものです。その面だけを選んでください。</translation>
    </message>
    <message>
        <source>a ball&apos;s lattice lies on a spherical face: choose one, or another Mapping.</source>
        <translation>球の格子は球面上にあります。球面か別のマッピングを選んでください。</translation>
    </message>
    <message>
        <source>an icosahedral lattice has {} or {}: choose one of these, or another lattice.</source>
        <translation>正二十面体型の格子は {} 個か {} 個です。そのどちらかか、別の格子を選んでください。</translation>
    </message>
    <message>
        <source>give Projected, On surface or Ball.</source>
        <translation>投影、面に沿う、球のいずれかを指定してください。</translation>
    </message>
    <message>
        <source>give less than the tool&apos;s diameter, {} mm, and the ball&apos;s.</source>
        <translation>工具の直径 {} mm と球の直径より小さくしてください。</translation>
    </message>
    <message>
        <source>on a ball one follows from the other: give 0 for one of them.</source>
        <translation>球では一方から他方が決まります。どちらかを 0 にしてください。</translation>
    </message>
    <message>
        <source>only a ball is seen from all sides: use patchmill.simulate.</source>
        <translation>全周から見るのは球だけです。patchmill.simulate を使ってください。</translation>
    </message>
    <message>
        <source>several spheres</source>
        <translation>複数の球</translation>
    </message>
    <message>
        <source>give a value from {} to {}.</source>
        <translation>{} から {} の値を指定してください。</translation>
    </message>
    <message>
        <source>{} mm, more than {} million triangles</source>
        <translation>{} mm、三角形 {} 百万超</translation>
    </message>
    <message>
        <source>give 0, or choose a constant-feed strategy: a paced path takes none.</source>
        <translation>0 を指定するか、送り一定の方式を選んでください。歩調を合わせた経路では使いません。</translation>
    </message>
    <message>
        <source>A ball of diameter {} reaches {:.0f} % of the faces.</source>
        <translation>直径 {} のボールは面の {:.0f} % に届きます。</translation>
    </message>
    <message>
        <source>the mesh {}</source>
        <translation>メッシュ {}</translation>
    </message>
    <message>
        <source>it has no faces for a job. In FreeCAD&apos;s Python console patchmill.mesh_texture makes a program for it.</source>
        <translation>ジョブに使える面がありません。FreeCAD の Python コンソールで patchmill.mesh_texture がプログラムを作ります。</translation>
    </message>
    <message>
        <source>a mesh has no cylinder to be turned about: choose Helix or Rows.</source>
        <translation>メッシュには回転の中心となる円筒がありません。Helix か Rows を選んでください。</translation>
    </message>
    <message>
        <source>a mesh has no face to lay a lattice on by its own lines: choose Projected.</source>
        <translation>メッシュには格子を自身の線に沿って置ける面がありません。Projected を選んでください。</translation>
    </message>
    <message>
        <source>beside {} faces</source>
        <translation>{} 個の面とともに</translation>
    </message>
    <message>
        <source>give a Mesh object, or an STL, OBJ or PLY file.</source>
        <translation>メッシュオブジェクト、または STL、OBJ、PLY ファイルを指定してください。</translation>
    </message>
    <message>
        <source>give a file that ends in {}.</source>
        <translation>末尾が {} のファイルを指定してください。</translation>
    </message>
    <message>
        <source>give a mesh or faces, not both.</source>
        <translation>メッシュか面のどちらか一方を指定してください。</translation>
    </message>
    <message>
        <source>give a mesh that has some.</source>
        <translation>三角形のあるメッシュを指定してください。</translation>
    </message>
    <message>
        <source>give numbers of 0 to {}.</source>
        <translation>0 から {} までの番号を指定してください。</translation>
    </message>
    <message>
        <source>give one of them.</source>
        <translation>どちらか一方を指定してください。</translation>
    </message>
    <message>
        <source>give the number of a triangle, 0 to {}.</source>
        <translation>三角形の番号を 0 から {} までで指定してください。</translation>
    </message>
    <message>
        <source>give the numbers of some triangles.</source>
        <translation>三角形の番号を指定してください。</translation>
    </message>
    <message>
        <source>give the numbers of those that are meant.</source>
        <translation>対象の番号を指定してください。</translation>
    </message>
    <message>
        <source>give the surface that is projected on.</source>
        <translation>投影先の表面を指定してください。</translation>
    </message>
    <message>
        <source>give three finite numbers in mm.</source>
        <translation>mm 単位の有限な数を 3 つ指定してください。</translation>
    </message>
    <message>
        <source>give triangles whose corners are apart.</source>
        <translation>頂点が互いに離れた三角形を指定してください。</translation>
    </message>
    <message>
        <source>it cannot be read ({}).</source>
        <translation>読み込めません ({})。</translation>
    </message>
    <message>
        <source>it holds no triangles.</source>
        <translation>三角形が含まれていません。</translation>
    </message>
    <message>
        <source>nearest and triangles</source>
        <translation>nearest と triangles</translation>
    </message>
    <message>
        <source>no area</source>
        <translation>面積なし</translation>
    </message>
    <message>
        <source>no mesh</source>
        <translation>メッシュなし</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>そのようなファイルはありません。</translation>
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
