<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="cs" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Soubor</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>Ú&amp;pravy</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Zobrazení</translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation>&amp;Nastavení</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Nápo&amp;věda</translation>
    </message>
    <message>
        <source>&amp;Prepare Animation…</source>
        <translation>&amp;Připravit animaci…</translation>
    </message>
    <message>
        <source>Turn a folder of meshes, a point cache or a scene into an .anim file</source>
        <translation>Vytvořit soubor .anim ze složky sítí, z mezipaměti bodů nebo ze scény</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Otevřít…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Uložit</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Uložit &amp;jako…</translation>
    </message>
    <message>
        <source>&amp;Frames…</source>
        <translation>&amp;Snímky…</translation>
    </message>
    <message>
        <source>Write every frame as an OBJ, OFF or PLY file</source>
        <translation>Zapsat každý snímek jako soubor OBJ, OFF nebo PLY</translation>
    </message>
    <message>
        <source>Point &amp;Cache…</source>
        <translation>&amp;Mezipaměť bodů…</translation>
    </message>
    <message>
        <source>Write all positions as one PC2 point cache</source>
        <translation>Zapsat všechny polohy do jedné mezipaměti bodů PC2</translation>
    </message>
    <message>
        <source>&amp;Screenshot…</source>
        <translation>&amp;Obrázek…</translation>
    </message>
    <message>
        <source>Write a picture of the frame shown</source>
        <translation>Zapsat obrázek zobrazeného snímku</translation>
    </message>
    <message>
        <source>Picture Se&amp;quence…</source>
        <translation>&amp;Posloupnost obrázků…</translation>
    </message>
    <message>
        <source>Write the playback as numbered PNG pictures</source>
        <translation>Zapsat přehrávání jako číslované obrázky PNG</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Načíst znovu</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Zavřít</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>U&amp;končit</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Zpět</translation>
    </message>
    <message>
        <source>Take back the last step</source>
        <translation>Vrátit poslední krok</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Z&amp;novu</translation>
    </message>
    <message>
        <source>Carry out the step that was taken back</source>
        <translation>Znovu provést vrácený krok</translation>
    </message>
    <message>
        <source>&amp;Trim to Range…</source>
        <translation>&amp;Oříznout na rozsah…</translation>
    </message>
    <message>
        <source>Keep only a range of frames</source>
        <translation>Ponechat jen rozsah snímků</translation>
    </message>
    <message>
        <source>Re&amp;verse</source>
        <translation>O&amp;brátit</translation>
    </message>
    <message>
        <source>Make the last frame the first</source>
        <translation>Poslední snímek bude první</translation>
    </message>
    <message>
        <source>Re&amp;sample…</source>
        <translation>Pře&amp;vzorkovat…</translation>
    </message>
    <message>
        <source>The same speed with more or fewer frames</source>
        <translation>Stejná rychlost s více nebo méně snímky</translation>
    </message>
    <message>
        <source>&amp;Frame Rate…</source>
        <translation>&amp;Snímková frekvence…</translation>
    </message>
    <message>
        <source>The same frames, played faster or slower</source>
        <translation>Stejné snímky, přehrávané rychleji nebo pomaleji</translation>
    </message>
    <message>
        <source>&amp;Normalise…</source>
        <translation>&amp;Normalizovat…</translation>
    </message>
    <message>
        <source>Move and scale the animation into the unit cube</source>
        <translation>Posunout a zvětšit nebo zmenšit animaci do jednotkové krychle</translation>
    </message>
    <message>
        <source>Re&amp;name…</source>
        <translation>Pře&amp;jmenovat…</translation>
    </message>
    <message>
        <source>Give the animation another name</source>
        <translation>Dát animaci jiné jméno</translation>
    </message>
    <message>
        <source>&amp;Shaded</source>
        <translation>&amp;Stínovaně</translation>
    </message>
    <message>
        <source>Draw smooth surfaces</source>
        <translation>Kreslit hladké plochy</translation>
    </message>
    <message>
        <source>Shaded with &amp;Edges</source>
        <translation>Stínovaně s &amp;hranami</translation>
    </message>
    <message>
        <source>Draw surfaces and the edges of their triangles</source>
        <translation>Kreslit plochy a hrany jejich trojúhelníků</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>&amp;Drátový model</translation>
    </message>
    <message>
        <source>Draw only the edges of the triangles</source>
        <translation>Kreslit jen hrany trojúhelníků</translation>
    </message>
    <message>
        <source>&amp;Points</source>
        <translation>&amp;Body</translation>
    </message>
    <message>
        <source>Draw only the vertices</source>
        <translation>Kreslit jen vrcholy</translation>
    </message>
    <message>
        <source>S&amp;tatistics</source>
        <translation>S&amp;tatistika</translation>
    </message>
    <message>
        <source>Show sizes and times over the picture</source>
        <translation>Zobrazit přes obraz velikosti a časy</translation>
    </message>
    <message>
        <source>&amp;Fit to Window</source>
        <translation>&amp;Přizpůsobit oknu</translation>
    </message>
    <message>
        <source>Move the camera so that everything is seen</source>
        <translation>Posunout kameru tak, aby bylo vidět vše</translation>
    </message>
    <message>
        <source>Show the next tab</source>
        <translation>Zobrazit další kartu</translation>
    </message>
    <message>
        <source>Show the previous tab</source>
        <translation>Zobrazit předchozí kartu</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>&amp;Celá obrazovka</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Použít celou obrazovku</translation>
    </message>
    <message>
        <source>Configure &amp;Shortcuts…</source>
        <translation>Nastavit &amp;zkratky…</translation>
    </message>
    <message>
        <source>Choose the keys of every action</source>
        <translation>Zvolit klávesy všech akcí</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts</source>
        <translation>&amp;Klávesové zkratky</translation>
    </message>
    <message>
        <source>Show all keys on one page</source>
        <translation>Zobrazit všechny klávesy na jedné stránce</translation>
    </message>
    <message>
        <source>&amp;Licences</source>
        <translation>&amp;Licence</translation>
    </message>
    <message>
        <source>The libraries that Sandreel is made with, and their licences</source>
        <translation>Knihovny, které Sandreel používá, a jejich licence</translation>
    </message>
    <message>
        <source>&amp;About Sandreel</source>
        <translation>&amp;O programu Sandreel</translation>
    </message>
    <message>
        <source>What this program is</source>
        <translation>Co je to za program</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Zpět: %1</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>Z&amp;novu: %1</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>Přehrá&amp;vání</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Otevřít &amp;nedávné</translation>
    </message>
    <message>
        <source>Open Sa&amp;mple</source>
        <translation>Otevřít &amp;ukázku</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportovat</translation>
    </message>
    <message>
        <source>&amp;Docks</source>
        <translation>&amp;Panely</translation>
    </message>
    <message>
        <source>&amp;Toolbars</source>
        <translation>Panely &amp;nástrojů</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Jazyk</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Motiv</translation>
    </message>
    <message>
        <source>Like the &amp;System</source>
        <translation>Podle &amp;systému</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Světlý</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Tmavý</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (chybí)</translation>
    </message>
    <message>
        <source>No Recent Files</source>
        <translation>Žádné nedávné soubory</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>&amp;Vymazat seznam</translation>
    </message>
    <message>
        <source>No Samples</source>
        <translation>Žádné ukázky</translation>
    </message>
    <message>
        <source>&amp;Compare with Original…</source>
        <translation>&amp;Porovnat s originálem…</translation>
    </message>
    <message>
        <source>Show what this animation lost of another one</source>
        <translation>Ukázat, co tato animace ztratila oproti jiné</translation>
    </message>
    <message>
        <source>St&amp;op Comparing</source>
        <translation>&amp;Ukončit porovnání</translation>
    </message>
    <message>
        <source>Forget the original</source>
        <translation>Zapomenout originál</translation>
    </message>
    <message>
        <source>Colour by &amp;Error</source>
        <translation>Obarvit podle &amp;chyby</translation>
    </message>
    <message>
        <source>Colour the mesh by how far each vertex is from the original</source>
        <translation>Obarvit síť podle vzdálenosti vrcholů od originálu</translation>
    </message>
    <message>
        <source>Colour &amp;Range of This Frame</source>
        <translation>&amp;Rozsah barev z tohoto snímku</translation>
    </message>
    <message>
        <source>Let the colours reach to the frame&apos;s largest error instead of that of all frames</source>
        <translation>Barvy sahají k největší chybě tohoto snímku místo všech snímků</translation>
    </message>
    <message>
        <source>Save the document to its file</source>
        <translation>Uloží dokument do jeho souboru</translation>
    </message>
    <message>
        <source>Save the document to another file</source>
        <translation>Uloží dokument do jiného souboru</translation>
    </message>
    <message>
        <source>Read the file again; the camera stays</source>
        <translation>Načte soubor znovu; pohled zůstane</translation>
    </message>
    <message>
        <source>Close the document</source>
        <translation>Zavře dokument</translation>
    </message>
    <message>
        <source>Close all documents and quit</source>
        <translation>Zavře všechny dokumenty a ukončí program</translation>
    </message>
    <message>
        <source>&amp;Next Document</source>
        <translation>&amp;Další dokument</translation>
    </message>
    <message>
        <source>Pre&amp;vious Document</source>
        <translation>P&amp;ředchozí dokument</translation>
    </message>
    <message>
        <source>&amp;New Terrain…</source>
        <translation>&amp;Nový terén…</translation>
    </message>
    <message>
        <source>Make a terrain: flat, dunes or hills</source>
        <translation>Vytvoří terén: rovinu, duny nebo kopce</translation>
    </message>
    <message>
        <source>&amp;Import Terrain…</source>
        <translation>&amp;Importovat terén…</translation>
    </message>
    <message>
        <source>Make a terrain of an elevation model, of points or of a mesh</source>
        <translation>Vytvoří terén z výškového modelu, z bodů nebo ze sítě</translation>
    </message>
    <message>
        <source>&amp;Terrain…</source>
        <translation>&amp;Terén…</translation>
    </message>
    <message>
        <source>Write the terrain as a mesh, a raster or contours</source>
        <translation>Zapíše terén jako síť, rastr nebo vrstevnice</translation>
    </message>
    <message>
        <source>Scu&amp;lpt</source>
        <translation>&amp;Modelovat</translation>
    </message>
    <message>
        <source>The left button draws with the tool; else it turns the picture</source>
        <translation>Levé tlačítko kreslí nástrojem, jinak otáčí obrazem</translation>
    </message>
    <message>
        <source>&amp;Ground</source>
        <translation>&amp;Povrch</translation>
    </message>
    <message>
        <source>Colour by &amp;Material</source>
        <translation>Barvit podle &amp;materiálu</translation>
    </message>
    <message>
        <source>Draw the ground as what it is made of</source>
        <translation>Kreslit povrch jako to, z čeho je</translation>
    </message>
    <message>
        <source>Colour by &amp;Height</source>
        <translation>Barvit podle &amp;výšky</translation>
    </message>
    <message>
        <source>Colour the ground by its height</source>
        <translation>Obarvit povrch podle výšky</translation>
    </message>
    <message>
        <source>Colour by &amp;Slope</source>
        <translation>Barvit podle &amp;sklonu</translation>
    </message>
    <message>
        <source>Colour the ground by how steep it is</source>
        <translation>Obarvit povrch podle toho, jak je strmý</translation>
    </message>
    <message>
        <source>Colour by H&amp;umidity</source>
        <translation>Barvit podle v&amp;lhkosti</translation>
    </message>
    <message>
        <source>Colour the ground by how wet the layer on top is</source>
        <translation>Obarvit povrch podle vlhkosti svrchní vrstvy</translation>
    </message>
    <message>
        <source>Colour by &amp;Thickness</source>
        <translation>Barvit podle &amp;tloušťky</translation>
    </message>
    <message>
        <source>Colour the ground by how much loose material lies on the bedrock</source>
        <translation>Obarvit povrch podle toho, kolik sypkého materiálu leží na skále</translation>
    </message>
    <message>
        <source>&amp;Contour Lines</source>
        <translation>Vrst&amp;evnice</translation>
    </message>
    <message>
        <source>Draw lines of equal height</source>
        <translation>Kreslit čáry stejné výšky</translation>
    </message>
    <message>
        <source>&amp;Edges of Triangles</source>
        <translation>&amp;Hrany trojúhelníků</translation>
    </message>
    <message>
        <source>Draw the triangles that the ground is made of</source>
        <translation>Kreslit trojúhelníky, ze kterých povrch je</translation>
    </message>
    <message>
        <source>Constrained E&amp;dges</source>
        <translation>V&amp;ázané hrany</translation>
    </message>
    <message>
        <source>Draw the edges that stamps and breaklines hold in place</source>
        <translation>Kreslit hrany, které drží otisky a zlomy</translation>
    </message>
    <message>
        <source>&amp;Low Quality</source>
        <translation>&amp;Nízká kvalita</translation>
    </message>
    <message>
        <source>Plain shading, for computers without a graphics card</source>
        <translation>Prosté stínování, pro počítače bez grafické karty</translation>
    </message>
    <message>
        <source>Medium &amp;Quality</source>
        <translation>Střední &amp;kvalita</translation>
    </message>
    <message>
        <source>Shadows and grains</source>
        <translation>Stíny a zrna</translation>
    </message>
    <message>
        <source>Hi&amp;gh Quality</source>
        <translation>Vyso&amp;ká kvalita</translation>
    </message>
    <message>
        <source>Grains on steep walls too, ripples and glints</source>
        <translation>Zrna i na strmých stěnách, vlnky a záblesky</translation>
    </message>
    <message>
        <source>&amp;Plain Recipe of Sand</source>
        <translation>&amp;Prostý recept na písek</translation>
    </message>
    <message>
        <source>A bump map with its contrast stretched, instead of sand as it looks outside</source>
        <translation>Hrbolatá mapa s roztaženým kontrastem místo písku, jak vypadá venku</translation>
    </message>
    <message>
        <source>&amp;Terrain</source>
        <translation>&amp;Terén</translation>
    </message>
    <message>
        <source>&amp;Tool</source>
        <translation>&amp;Nástroj</translation>
    </message>
    <message>
        <source>S&amp;ymmetry</source>
        <translation>&amp;Souměrnost</translation>
    </message>
    <message>
        <source>Colour by Cut &amp;and Fill</source>
        <translation>Barvit podle &amp;výkopů a násypů</translation>
    </message>
    <message>
        <source>Colour the ground by how much lower or higher it is than the reference: when it was opened or saved, or the moment that was taken</source>
        <translation>Obarvit povrch podle toho, o kolik je níž nebo výš než vzor: při otevření či uložení, nebo v převzatém okamžiku</translation>
    </message>
    <message>
        <source>Colour by Mas&amp;k</source>
        <translation>Barvit podle mas&amp;ky</translation>
    </message>
    <message>
        <source>Colour the ground by how far it is protected from tools</source>
        <translation>Obarvit povrch podle toho, nakolik je chráněn před nástroji</translation>
    </message>
    <message>
        <source>Acti&amp;ve Triangles</source>
        <translation>&amp;Aktivní trojúhelníky</translation>
    </message>
    <message>
        <source>Mark the triangles that may still slide</source>
        <translation>Vyznačit trojúhelníky, které se ještě mohou sesunout</translation>
    </message>
    <message>
        <source>&amp;Bigger Tool</source>
        <translation>&amp;Větší nástroj</translation>
    </message>
    <message>
        <source>Make the tool a tenth wider</source>
        <translation>Rozšířit nástroj o desetinu</translation>
    </message>
    <message>
        <source>S&amp;maller Tool</source>
        <translation>&amp;Menší nástroj</translation>
    </message>
    <message>
        <source>Make the tool a tenth narrower</source>
        <translation>Zúžit nástroj o desetinu</translation>
    </message>
    <message>
        <source>St&amp;ronger Tool</source>
        <translation>S&amp;ilnější nástroj</translation>
    </message>
    <message>
        <source>Let each stamp do a quarter more</source>
        <translation>Každý otisk udělá o čtvrtinu víc</translation>
    </message>
    <message>
        <source>&amp;Weaker Tool</source>
        <translation>S&amp;labší nástroj</translation>
    </message>
    <message>
        <source>Let each stamp do a fifth less</source>
        <translation>Každý otisk udělá o pětinu míň</translation>
    </message>
    <message>
        <source>S&amp;lide While Drawing</source>
        <translation>Sesouvat při &amp;kreslení</translation>
    </message>
    <message>
        <source>What is too steep slides while you draw and after it</source>
        <translation>Co je příliš strmé, sesouvá se při kreslení i po něm</translation>
    </message>
    <message>
        <source>&amp;Run Erosion</source>
        <translation>Spustit &amp;erozi</translation>
    </message>
    <message>
        <source>Let everything that is too steep slide, or hold it</source>
        <translation>Nechat sesouvat vše, co je příliš strmé, nebo to zastavit</translation>
    </message>
    <message>
        <source>Step &amp;Erosion</source>
        <translation>K&amp;rok eroze</translation>
    </message>
    <message>
        <source>Go once over everything that is too steep</source>
        <translation>Projít jednou vše, co je příliš strmé</translation>
    </message>
    <message>
        <source>Erode &amp;Until Settled</source>
        <translation>Erodovat až do &amp;ustálení</translation>
    </message>
    <message>
        <source>Let everything slide in the background, until no face is too steep</source>
        <translation>Nechat vše sesouvat na pozadí, dokud bude některý trojúhelník příliš strmý</translation>
    </message>
    <message>
        <source>Take Re&amp;ference</source>
        <translation>Převzít vz&amp;or</translation>
    </message>
    <message>
        <source>Restore, cut and fill, and the cross-section go by the ground as it is now</source>
        <translation>Obnova, výkopy a násypy i řez se budou řídit povrchem, jaký je nyní</translation>
    </message>
    <message>
        <source>Clear Mas&amp;k</source>
        <translation>Smazat mas&amp;ku</translation>
    </message>
    <message>
        <source>Open all ground to tools</source>
        <translation>Zpřístupnit nástrojům celý povrch</translation>
    </message>
    <message>
        <source>&amp;Invert Mask</source>
        <translation>O&amp;brátit masku</translation>
    </message>
    <message>
        <source>Protect what is open, and open what is protected</source>
        <translation>Chránit, co je přístupné, a zpřístupnit, co je chráněné</translation>
    </message>
    <message>
        <source>Paint M&amp;ask</source>
        <translation>M&amp;alovat masku</translation>
    </message>
    <message>
        <source>The left button protects ground from all tools; with Ctrl it opens it again</source>
        <translation>Levé tlačítko chrání povrch před všemi nástroji; s Ctrl ho zase zpřístupní</translation>
    </message>
    <message>
        <source>Pick &amp;Cross-Section</source>
        <translation>Vést ře&amp;z</translation>
    </message>
    <message>
        <source>The left button draws the line along which the ground is cut, and moves its ends</source>
        <translation>Levé tlačítko kreslí čáru, podél níž se povrch řeže, a posouvá její konce</translation>
    </message>
    <message>
        <source>&amp;Off</source>
        <translation>&amp;Vypnuto</translation>
    </message>
    <message>
        <source>&amp;Left and Right</source>
        <translation>V&amp;levo a vpravo</translation>
    </message>
    <message>
        <source>&amp;Front and Back</source>
        <translation>V&amp;předu a vzadu</translation>
    </message>
    <message>
        <source>&amp;Both</source>
        <translation>&amp;Obojí</translation>
    </message>
    <message>
        <source>&amp;Around</source>
        <translation>&amp;Dokola</translation>
    </message>
    <message>
        <source>Draw mirrored or turned copies of each stroke</source>
        <translation>Kreslit zrcadlené nebo otočené kopie každého tahu</translation>
    </message>
    <message>
        <source>&amp;Pause Erosion</source>
        <translation>Pozastavit &amp;erozi</translation>
    </message>
    <message>
        <source>Write a picture of the terrain</source>
        <translation>Uloží obrázek terénu</translation>
    </message>
    <message>
        <source>T&amp;urntable…</source>
        <translation>&amp;Otáčení…</translation>
    </message>
    <message>
        <source>Write pictures from all around the terrain</source>
        <translation>Uloží obrázky terénu ze všech stran</translation>
    </message>
    <message>
        <source>&amp;Record as Animation</source>
        <translation>&amp;Nahrávat jako animaci</translation>
    </message>
    <message>
        <source>Record what happens to the terrain; again: stop, and show it as an animation</source>
        <translation>Nahrává, co se s terénem děje; podruhé nahrávání ukončí a ukáže je jako animaci</translation>
    </message>
    <message>
        <source>Feel with the Mouse (&amp;Haptics)</source>
        <translation>Ohmatávat myší (&amp;haptika)</translation>
    </message>
    <message>
        <source>The mouse moves the simulated haptic device, the wheel presses it in</source>
        <translation>Myš pohybuje simulovaným haptickým zařízením, kolečko ho zatlačuje</translation>
    </message>
    <message>
        <source>Haptic F&amp;orces</source>
        <translation>Haptické síl&amp;y</translation>
    </message>
    <message>
        <source>Let the haptic device push; off at every start</source>
        <translation>Haptické zařízení smí tlačit; po spuštění vždy vypnuto</translation>
    </message>
    <message>
        <source>Sto&amp;p All Forces</source>
        <translation>Vy&amp;pnout všechny síly</translation>
    </message>
    <message>
        <source>Forces off, at once; Escape does the same anywhere</source>
        <translation>Okamžitě vypne síly; Escape udělá totéž kdekoli</translation>
    </message>
    <message>
        <source>Open an animation, a terrain or a mesh</source>
        <translation>Otevře animaci, terén nebo síť</translation>
    </message>
    <message>
        <source>&amp;Inspect Frame</source>
        <translation>&amp;Prozkoumat snímek</translation>
    </message>
    <message>
        <source>Open the frame shown as a mesh, to see what it is made of</source>
        <translation>Otevře zobrazený snímek jako síť, aby bylo vidět, z čeho se skládá</translation>
    </message>
    <message>
        <source>&amp;Mesh</source>
        <translation>&amp;Síť</translation>
    </message>
    <message>
        <source>&amp;Fill Holes</source>
        <translation>&amp;Zaplnit díry</translation>
    </message>
    <message>
        <source>Close the holes that are selected in the inspector by smooth lids</source>
        <translation>Uzavře díry vybrané v inspektoru hladkými víky</translation>
    </message>
    <message>
        <source>&amp;Cut Handle</source>
        <translation>&amp;Rozříznout ucho</translation>
    </message>
    <message>
        <source>Cut the selected handle open along its short loop and close both ends</source>
        <translation>Rozřízne vybrané ucho podél krátké smyčky a oba konce uzavře</translation>
    </message>
    <message>
        <source>&amp;Delete Components</source>
        <translation>&amp;Odstranit komponenty</translation>
    </message>
    <message>
        <source>Delete the components that are selected in the inspector</source>
        <translation>Odstraní komponenty vybrané v inspektoru</translation>
    </message>
    <message>
        <source>&amp;Weld Vertices</source>
        <translation>&amp;Svařit vrcholy</translation>
    </message>
    <message>
        <source>Make one of the vertices that are exactly at one place</source>
        <translation>Z vrcholů, které jsou přesně na jednom místě, udělá jeden</translation>
    </message>
    <message>
        <source>&amp;Orient Faces</source>
        <translation>Sjednotit o&amp;rientaci stěn</translation>
    </message>
    <message>
        <source>Turn faces until neighbours are wound alike and solids are not inside out</source>
        <translation>Obrací stěny, až jsou sousední orientovány stejně a tělesa nejsou naruby</translation>
    </message>
    <message>
        <source>Remove De&amp;generate Faces</source>
        <translation>Odstranit de&amp;generované stěny</translation>
    </message>
    <message>
        <source>Remove faces that have fewer than three different corners</source>
        <translation>Odstraní stěny, které mají méně než tři různé rohy</translation>
    </message>
    <message>
        <source>Remove D&amp;uplicate Faces</source>
        <translation>Odstranit opakované s&amp;těny</translation>
    </message>
    <message>
        <source>Of faces with the same corners keep the first</source>
        <translation>Ze stěn se stejnými rohy ponechá první</translation>
    </message>
    <message>
        <source>Remove &amp;Isolated Vertices</source>
        <translation>Odstranit &amp;izolované vrcholy</translation>
    </message>
    <message>
        <source>Remove vertices that no face uses</source>
        <translation>Odstraní vrcholy, které nejsou v žádné stěně</translation>
    </message>
    <message>
        <source>&amp;Split Non-Manifold Parts</source>
        <translation>Rozdělit &amp;nevariety</translation>
    </message>
    <message>
        <source>Give each sheet and each fan of faces edges and vertices of its own</source>
        <translation>Každému listu a každému vějíři stěn dá vlastní hrany a vrcholy</translation>
    </message>
    <message>
        <source>&amp;Halve the Triangles</source>
        <translation>Zmenšit počet trojúhelníků na &amp;polovinu</translation>
    </message>
    <message>
        <source>Draw edges together until half the triangles are left, where it shows least</source>
        <translation>Stahuje hrany, kde je to nejméně vidět, dokud nezbude polovina trojúhelníků</translation>
    </message>
    <message>
        <source>Su&amp;bdivide</source>
        <translation>&amp;Dělit trojúhelníky</translation>
    </message>
    <message>
        <source>Put four smooth triangles in place of each</source>
        <translation>Každý trojúhelník nahradí čtyřmi hladkými</translation>
    </message>
    <message>
        <source>S&amp;mooth</source>
        <translation>V&amp;yhladit</translation>
    </message>
    <message>
        <source>Smooth the surface without shrinking it</source>
        <translation>Vyhladí povrch, aniž by ho smrštil</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Language of the interface: en or cs.</source>
        <translation>Jazyk rozhraní: en nebo cs.</translation>
    </message>
    <message>
        <source>Colours: light, dark or system.</source>
        <translation>Barvy: light (světlé), dark (tmavé) nebo system (podle systému).</translation>
    </message>
    <message>
        <source>Size of the window, for example 1280x800.</source>
        <translation>Velikost okna, například 1280x800.</translation>
    </message>
    <message>
        <source>Go to this frame; the first is 1.</source>
        <translation>Přejít na tento snímek; první má číslo 1.</translation>
    </message>
    <message>
        <source>Start playing.</source>
        <translation>Spustit přehrávání.</translation>
    </message>
    <message>
        <source>Write a picture of the window to FILE and quit.</source>
        <translation>Zapsat obrázek okna do souboru FILE a skončit.</translation>
    </message>
    <message>
        <source>Wait this many milliseconds after everything is open.</source>
        <translation>Po otevření všeho počkat tolik milisekund.</translation>
    </message>
    <message>
        <source>Animations to open; folders, point caches, scenes and meshes to prepare.</source>
        <translation>Animace k otevření; složky, mezipaměti bodů, scény a sítě k přípravě.</translation>
    </message>
    <message>
        <source>Option --%1 does not take the value &quot;%2&quot;.</source>
        <translation>Přepínač --%1 nemůže mít hodnotu „%2“.</translation>
    </message>
    <message>
        <source>Show what the last animation lost of this original.</source>
        <translation>Ukázat, co poslední animace ztratila oproti tomuto originálu.</translation>
    </message>
    <message>
        <source>Sandreel plays mesh animations and shapes sandy terrain.</source>
        <translation>Sandreel přehrává animace sítí a tvaruje písčitý terén.</translation>
    </message>
</context>
<context>
    <name>Documents</name>
    <message>
        <source>Animations</source>
        <translation>Animace</translation>
    </message>
    <message>
        <source>Terrains</source>
        <translation>Terény</translation>
    </message>
    <message>
        <source>%1 (process %2 on %3)</source>
        <translation>%1 (proces %2 na %3)</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>Sítě</translation>
    </message>
</context>
<context>
    <name>ErrorText</name>
    <message>
        <source>The folder holds no frames. Files ending in %1 are taken as frames.</source>
        <translation>Ve složce nejsou žádné snímky. Za snímky se považují soubory s příponou %1.</translation>
    </message>
    <message>
        <source>Files ending in &quot;%1&quot; cannot be read.</source>
        <translation>Soubory s příponou „%1“ nelze číst.</translation>
    </message>
    <message>
        <source>Expected %1, but found %2.</source>
        <translation>Očekáváno %1, nalezeno %2.</translation>
    </message>
    <message>
        <source>A number is infinite or not a number: %1.</source>
        <translation>Hodnota je nekonečná nebo to není číslo: %1.</translation>
    </message>
    <message>
        <source>A face uses vertex %1, but there are %2 vertices.</source>
        <translation>Stěna používá vrchol %1, ale počet vrcholů je %2.</translation>
    </message>
    <message>
        <source>The mesh has no vertices.</source>
        <translation>Síť nemá žádné vrcholy.</translation>
    </message>
    <message>
        <source>Triangle %1 differs from that in %2. All frames of an animation need the same faces in the same order.</source>
        <translation>Trojúhelník %1 se liší od trojúhelníku v souboru %2. Všechny snímky animace musí mít stejné stěny ve stejném pořadí.</translation>
    </message>
    <message>
        <source>This mesh has %1 triangles, but %3 has %2. All frames of an animation need the same faces.</source>
        <translation>Tato síť má trojúhelníků: %1, ale %3 jich má: %2. Všechny snímky animace musí mít stejné stěny.</translation>
    </message>
    <message>
        <source>The file ends too early: %1 bytes are needed, %2 are there. It may have been copied incompletely.</source>
        <translation>Soubor končí příliš brzy: potřebných bajtů je %1, k dispozici jen %2. Možná se nezkopíroval celý.</translation>
    </message>
    <message>
        <source>There are %1 bytes too many at the end. The file may be damaged.</source>
        <translation>Na konci jsou přebytečné bajty, celkem %1. Soubor je možná poškozený.</translation>
    </message>
    <message>
        <source>The file is not a %1 file: it does not start as one.</source>
        <translation>Toto není soubor %1: nezačíná tak, jak má.</translation>
    </message>
    <message>
        <source>The file has format version %1, but this program reads versions up to %2. A newer program may open it.</source>
        <translation>Soubor má verzi formátu %1, ale tento program čte jen verze do %2. Novější program ho možná otevře.</translation>
    </message>
    <message>
        <source>The file uses something that cannot be read: %1.</source>
        <translation>Soubor používá něco, co nelze číst: %1.</translation>
    </message>
    <message>
        <source>The file is damaged: the checksum of its part &quot;%1&quot; is wrong.</source>
        <translation>Soubor je poškozený: nesouhlasí kontrolní součet části „%1“.</translation>
    </message>
    <message>
        <source>The file is damaged: its part &quot;%1&quot; is missing.</source>
        <translation>Soubor je poškozený: chybí část „%1“.</translation>
    </message>
    <message>
        <source>The file is damaged: it has its part &quot;%1&quot; twice.</source>
        <translation>Soubor je poškozený: část „%1“ je v něm dvakrát.</translation>
    </message>
    <message>
        <source>The file is damaged: %1 is %2, but must be %3.</source>
        <translation>Soubor je poškozený: hodnota %1 je %2, ale má být %3.</translation>
    </message>
    <message>
        <source>The file was compressed with method %1, which this program does not know. A newer program may open it.</source>
        <translation>Soubor byl zkomprimován metodou %1, kterou tento program nezná. Novější program ho možná otevře.</translation>
    </message>
    <message>
        <source>The compressed data are damaged (%1).</source>
        <translation>Komprimovaná data jsou poškozená (%1).</translation>
    </message>
    <message>
        <source>A point cache has no faces of its own. Put its mesh beside it under the same name (for example walk.obj for walk.pc2), or choose one.</source>
        <translation>Mezipaměť bodů nemá vlastní stěny. Uložte vedle ní její síť pod stejným jménem (například walk.obj k walk.pc2), nebo ji vyberte.</translation>
    </message>
    <message>
        <source>The scene has nothing to animate: %1.</source>
        <translation>Ve scéně není co animovat: %1.</translation>
    </message>
    <message>
        <source>The two animations cannot be compared: %1 is %2 in one and %3 in the other.</source>
        <translation>Tyto dvě animace nelze porovnat: %1 je v jedné %2 a ve druhé %3.</translation>
    </message>
    <message>
        <source>This is not a permutation of the vertices: %1.</source>
        <translation>Toto není permutace vrcholů: %1.</translation>
    </message>
    <message>
        <source>The terrain is damaged: %1 (%2).</source>
        <translation>Terén je poškozený: %1 (%2).</translation>
    </message>
    <message>
        <source>The line from point %1 to point %2 crosses the fixed line from point %3 to point %4.</source>
        <translation>Úsečka z bodu %1 do bodu %2 kříží pevnou úsečku z bodu %3 do bodu %4.</translation>
    </message>
    <message>
        <source>%1 cannot be %2. Allowed: %3.</source>
        <translation>%1 nemůže být %2. Povoleno: %3.</translation>
    </message>
    <message>
        <source>The file cannot be opened: %1.</source>
        <translation>Soubor nelze otevřít: %1.</translation>
    </message>
    <message>
        <source>The file cannot be read: %1.</source>
        <translation>Soubor nelze přečíst: %1.</translation>
    </message>
    <message>
        <source>The file cannot be written: %1. Check the free space and the permissions.</source>
        <translation>Soubor nelze zapsat: %1. Zkontrolujte volné místo a oprávnění.</translation>
    </message>
    <message>
        <source>There is no such file or folder.</source>
        <translation>Takový soubor ani složka neexistuje.</translation>
    </message>
    <message>
        <source>Too large: %1 is %2, the limit is %3.</source>
        <translation>Příliš velké: %1 je %2, mez je %3.</translation>
    </message>
    <message>
        <source>There is not enough memory: %1 bytes are needed. Close other programs or use a smaller animation.</source>
        <translation>Nedostatek paměti: potřebných bajtů je %1. Zavřete jiné programy nebo použijte menší animaci.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Zrušeno.</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Řádek %1</translation>
    </message>
    <message>
        <source>Byte %1</source>
        <translation>Bajt %1</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, řádek %2</translation>
    </message>
    <message>
        <source>%1, byte %2</source>
        <translation>%1, bajt %2</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>složku nelze vytvořit</translation>
    </message>
    <message>
        <source>the folder holds frames already</source>
        <translation>ve složce už jsou snímky</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>je to složka</translation>
    </message>
    <message>
        <source>it is not an ordinary file</source>
        <translation>není to obyčejný soubor</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>vrchol %1</translation>
    </message>
    <message>
        <source>vertex %1 of frame %2</source>
        <translation>vrchol %1 ve snímku %2</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>trojúhelník %1</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>paměť</translation>
    </message>
    <message>
        <source>format version</source>
        <translation>verze formátu</translation>
    </message>
    <message>
        <source>vertex count</source>
        <translation>počet vrcholů</translation>
    </message>
    <message>
        <source>triangle count</source>
        <translation>počet trojúhelníků</translation>
    </message>
    <message>
        <source>frame count</source>
        <translation>počet snímků</translation>
    </message>
    <message>
        <source>rows per stream</source>
        <translation>řádky v proudu</translation>
    </message>
    <message>
        <source>stream count</source>
        <translation>počet proudů</translation>
    </message>
    <message>
        <source>chunk tag</source>
        <translation>značka části</translation>
    </message>
    <message>
        <source>letters and digits</source>
        <translation>písmena a číslice</translation>
    </message>
    <message>
        <source>at most the bytes left</source>
        <translation>nejvýše zbývající bajty</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>bod %1</translation>
    </message>
    <message>
        <source>number of points</source>
        <translation>počet bodů</translation>
    </message>
    <message>
        <source>extent of the terrain</source>
        <translation>rozměry terénu</translation>
    </message>
    <message>
        <source>more than nothing in both directions</source>
        <translation>v obou směrech více než nula</translation>
    </message>
    <message>
        <source>There are %1 vertices here, but %2 in %3. All frames of an animation and its base mesh need the same vertices.</source>
        <translation>Počet vrcholů je zde %1, ale v souboru %3 je to %2. Všechny snímky animace i její základní síť musí mít stejné vrcholy.</translation>
    </message>
    <message>
        <source>the size of the file in bytes</source>
        <translation>velikost souboru v bajtech</translation>
    </message>
    <message>
        <source>it is not a folder</source>
        <translation>není to složka</translation>
    </message>
    <message>
        <source>no permission to read it</source>
        <translation>chybí oprávnění ke čtení</translation>
    </message>
    <message>
        <source>a coordinate</source>
        <translation>souřadnice</translation>
    </message>
    <message>
        <source>a face with at least 3 corners</source>
        <translation>stěna s alespoň 3 rohy</translation>
    </message>
    <message>
        <source>a vertex number</source>
        <translation>číslo vrcholu</translation>
    </message>
    <message>
        <source>the number of vertices</source>
        <translation>počet vrcholů</translation>
    </message>
    <message>
        <source>the number of faces</source>
        <translation>počet stěn</translation>
    </message>
    <message>
        <source>vertices with other than 3 coordinates</source>
        <translation>vrcholy s jiným počtem souřadnic než 3</translation>
    </message>
    <message>
        <source>the binary form of OFF</source>
        <translation>binární podoba OFF</translation>
    </message>
    <message>
        <source>a line of a PLY header</source>
        <translation>řádek hlavičky PLY</translation>
    </message>
    <message>
        <source>a PLY format</source>
        <translation>formát PLY</translation>
    </message>
    <message>
        <source>the number of elements</source>
        <translation>počet prvků</translation>
    </message>
    <message>
        <source>triangle strips</source>
        <translation>pásy trojúhelníků</translation>
    </message>
    <message>
        <source>an integer type</source>
        <translation>celočíselný typ</translation>
    </message>
    <message>
        <source>a type</source>
        <translation>typ</translation>
    </message>
    <message>
        <source>vertices without one x, y and z each</source>
        <translation>vrcholy bez jednoho x, y a z</translation>
    </message>
    <message>
        <source>faces without one list of vertices</source>
        <translation>stěny bez jednoho seznamu vrcholů</translation>
    </message>
    <message>
        <source>an integer</source>
        <translation>celé číslo</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>hodnota</translation>
    </message>
    <message>
        <source>the length of a list</source>
        <translation>délka seznamu</translation>
    </message>
    <message>
        <source>the number of frames</source>
        <translation>počet snímků</translation>
    </message>
    <message>
        <source>the number of vertices times frames</source>
        <translation>počet vrcholů krát snímků</translation>
    </message>
    <message>
        <source>the scene contradicts itself</source>
        <translation>scéna si odporuje</translation>
    </message>
    <message>
        <source>for an unknown reason</source>
        <translation>z neznámého důvodu</translation>
    </message>
    <message>
        <source>The number of the animation</source>
        <translation>Číslo animace</translation>
    </message>
    <message>
        <source>there is no mesh in it</source>
        <translation>není v ní žádná síť</translation>
    </message>
    <message>
        <source>&quot;facet&quot; or &quot;endsolid&quot;</source>
        <translation>„facet“ nebo „endsolid“</translation>
    </message>
    <message>
        <source>&quot;solid&quot;</source>
        <translation>„solid“</translation>
    </message>
    <message>
        <source>&quot;normal&quot;</source>
        <translation>„normal“</translation>
    </message>
    <message>
        <source>&quot;outer loop&quot;</source>
        <translation>„outer loop“</translation>
    </message>
    <message>
        <source>&quot;endloop&quot;</source>
        <translation>„endloop“</translation>
    </message>
    <message>
        <source>&quot;endfacet&quot;</source>
        <translation>„endfacet“</translation>
    </message>
    <message>
        <source>&quot;vertex&quot;</source>
        <translation>„vertex“</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>konec souboru</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>konec řádku</translation>
    </message>
    <message>
        <source>There is not enough memory. Close other programs or use a smaller animation.</source>
        <translation>Nedostatek paměti. Zavřete jiné programy nebo použijte menší animaci.</translation>
    </message>
    <message>
        <source>size of the grid</source>
        <translation>velikost mřížky</translation>
    </message>
    <message>
        <source>at least %1 x %2</source>
        <translation>alespoň %1 x %2</translation>
    </message>
    <message>
        <source>column %1 of row %2</source>
        <translation>sloupec %1 řádku %2</translation>
    </message>
    <message>
        <source>constraint</source>
        <translation>pevná hrana</translation>
    </message>
    <message>
        <source>exception count</source>
        <translation>počet výjimek</translation>
    </message>
    <message>
        <source>layer count</source>
        <translation>počet vrstev</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>jednotka</translation>
    </message>
    <message>
        <source>packed size</source>
        <translation>velikost po zabalení</translation>
    </message>
    <message>
        <source>unpacked size</source>
        <translation>velikost po rozbalení</translation>
    </message>
    <message>
        <source>step count</source>
        <translation>počet kroků</translation>
    </message>
    <message>
        <source>reference size</source>
        <translation>velikost odkazů</translation>
    </message>
    <message>
        <source>outer vertex count</source>
        <translation>počet cizích vrcholů</translation>
    </message>
    <message>
        <source>outer vertex size</source>
        <translation>velikost cizích vrcholů</translation>
    </message>
    <message>
        <source>tile size</source>
        <translation>velikost dlaždice</translation>
    </message>
    <message>
        <source>tile count</source>
        <translation>počet dlaždic</translation>
    </message>
    <message>
        <source>number of materials</source>
        <translation>počet materiálů</translation>
    </message>
    <message>
        <source>number of layers</source>
        <translation>počet vrstev</translation>
    </message>
    <message>
        <source>number of levels</source>
        <translation>počet hladin</translation>
    </message>
    <message>
        <source>material of layer %1</source>
        <translation>materiál vrstvy %1</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>počátek</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>objem</translation>
    </message>
    <message>
        <source>height prediction</source>
        <translation>předpověď výšek</translation>
    </message>
    <message>
        <source>void mark</source>
        <translation>značka prázdna</translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>Soubor nelze přečíst: %1</translation>
    </message>
    <message>
        <source>The file holds no ground: every part of it is void.</source>
        <translation>Soubor neobsahuje žádný terén: celý je prázdný.</translation>
    </message>
    <message>
        <source>The mesh cannot be a terrain, which has one height at each place: %2, at %1. If height is not its z, say which axis is up.</source>
        <translation>Síť nemůže být terénem, který má na každém místě jedinou výšku: %2, na místě %1. Není-li výškou osa z, řekněte, která osa míří vzhůru.</translation>
    </message>
    <message>
        <source>band</source>
        <translation>pásmo</translation>
    </message>
    <message>
        <source>complex numbers</source>
        <translation>komplexní čísla</translation>
    </message>
    <message>
        <source>a grid that is turned</source>
        <translation>pootočená mřížka</translation>
    </message>
    <message>
        <source>cells that are not square; GeoTIFF has them</source>
        <translation>buňky, které nejsou čtvercové; umí je GeoTIFF</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>text</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>číslo</translation>
    </message>
    <message>
        <source>a list of [humidity, degrees]</source>
        <translation>seznam dvojic [vlhkost, stupně]</translation>
    </message>
    <message>
        <source>recovery</source>
        <translation>obnovovací</translation>
    </message>
    <message>
        <source>the saved file</source>
        <translation>uložený soubor</translation>
    </message>
    <message>
        <source>a face stands upright</source>
        <translation>některá stěna stojí svisle</translation>
    </message>
    <message>
        <source>a point lies above another</source>
        <translation>jeden bod leží nad druhým</translation>
    </message>
    <message>
        <source>edges cross, seen from above</source>
        <translation>hrany se při pohledu shora kříží</translation>
    </message>
    <message>
        <source>faces lie above one another</source>
        <translation>stěny leží nad sebou</translation>
    </message>
    <message>
        <source>a JSON object</source>
        <translation>objekt JSON</translation>
    </message>
    <message>
        <source>number of parts</source>
        <translation>počet částí</translation>
    </message>
    <message>
        <source>name of a part</source>
        <translation>jméno části</translation>
    </message>
    <message>
        <source>a relative path</source>
        <translation>relativní cesta</translation>
    </message>
    <message>
        <source>encryption</source>
        <translation>šifrování</translation>
    </message>
    <message>
        <source>another compression of its parts</source>
        <translation>jiná komprese jeho částí</translation>
    </message>
</context>
<context>
    <name>MeshFields</name>
    <message>
        <source>Mean Curvature</source>
        <translation>Střední křivost</translation>
    </message>
    <message>
        <source>Gaussian Curvature</source>
        <translation>Gaussova křivost</translation>
    </message>
    <message>
        <source>Valence</source>
        <translation>Valence</translation>
    </message>
    <message>
        <source>Codec Error</source>
        <translation>Chyba kodeku</translation>
    </message>
    <message>
        <source>Trajectory Length</source>
        <translation>Délka trajektorie</translation>
    </message>
    <message>
        <source>PCA Coefficient %1</source>
        <translation>Koeficient PCA %1</translation>
    </message>
</context>
<context>
    <name>MeshProblems</name>
    <message>
        <source>Edge of three faces or more</source>
        <translation>Hrana tří nebo více stěn</translation>
    </message>
    <message>
        <source>Vertex where fans of faces touch</source>
        <translation>Vrchol, kde se dotýkají vějíře stěn</translation>
    </message>
    <message>
        <source>Faces wound against each other</source>
        <translation>Stěny orientované proti sobě</translation>
    </message>
    <message>
        <source>Face with a vertex twice</source>
        <translation>Stěna s opakovaným vrcholem</translation>
    </message>
    <message>
        <source>Face without area</source>
        <translation>Stěna bez plochy</translation>
    </message>
    <message>
        <source>Face that is there twice</source>
        <translation>Zdvojená stěna</translation>
    </message>
    <message>
        <source>Vertex without faces</source>
        <translation>Vrchol bez stěn</translation>
    </message>
    <message>
        <source>Vertices at one place</source>
        <translation>Vrcholy na jednom místě</translation>
    </message>
    <message>
        <source>Component turned inside out</source>
        <translation>Komponenta naruby</translation>
    </message>
    <message>
        <source>Faces that cut each other</source>
        <translation>Protínající se stěny</translation>
    </message>
    <message>
        <source>Edge %1–%2</source>
        <translation>Hrana %1–%2</translation>
    </message>
    <message>
        <source>Vertices %1 and %2</source>
        <translation>Vrcholy %1 a %2</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>Vrchol %1</translation>
    </message>
    <message>
        <source>Component %1</source>
        <translation>Komponenta %1</translation>
    </message>
    <message>
        <source>Faces %1 and %2</source>
        <translation>Stěny %1 a %2</translation>
    </message>
    <message>
        <source>Face %1</source>
        <translation>Stěna %1</translation>
    </message>
</context>
<context>
    <name>PickReport</name>
    <message>
        <source>none</source>
        <translation>žádná</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Komponenta</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problém</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Stěna</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vrcholy</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Plocha</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normála</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Úhly</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Strany</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Hrana</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Délka</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Stěny</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Okraj</translation>
    </message>
    <message>
        <source>of a hole</source>
        <translation>díry</translation>
    </message>
    <message>
        <source>Angle between the faces</source>
        <translation>Úhel mezi stěnami</translation>
    </message>
    <message>
        <source>Vertex</source>
        <translation>Vrchol</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Poloha</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Sousedé</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Uložit</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>Uložit vše</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otevřít</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ano</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Ne</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zavřít</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Zahodit</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Nápověda</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>Cloth</source>
        <translation>Látka</translation>
    </message>
    <message>
        <source>Jellyfish</source>
        <translation>Medúza</translation>
    </message>
    <message>
        <source>Walker</source>
        <translation>Čtyřnožec</translation>
    </message>
    <message>
        <source>Dunes</source>
        <translation>Duny</translation>
    </message>
</context>
<context>
    <name>Tool</name>
    <message>
        <source>Imprint</source>
        <translation>Otisk</translation>
    </message>
    <message>
        <source>Rake</source>
        <translation>Hrábě</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>Zvednout</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Snížit</translation>
    </message>
    <message>
        <source>Flatten</source>
        <translation>Zarovnat</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Vyhladit</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Šum</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampa</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Obnovit</translation>
    </message>
    <message>
        <source>Pour</source>
        <translation>Nasypat</translation>
    </message>
    <message>
        <source>Scoop</source>
        <translation>Nabrat</translation>
    </message>
    <message>
        <source>Breakline</source>
        <translation>Lomová čára</translation>
    </message>
    <message>
        <source>Moisten</source>
        <translation>Navlhčit</translation>
    </message>
    <message>
        <source>Presses a rigid shape into the ground; what it displaces lies around it</source>
        <translation>Zatlačí pevný tvar do povrchu; co vytlačí, leží kolem něj</translation>
    </message>
    <message>
        <source>Draws grooves side by side</source>
        <translation>Kreslí rýhy vedle sebe</translation>
    </message>
    <message>
        <source>Adds material</source>
        <translation>Přidává materiál</translation>
    </message>
    <message>
        <source>Takes material away</source>
        <translation>Ubírá materiál</translation>
    </message>
    <message>
        <source>Draws the ground towards one level</source>
        <translation>Přitahuje povrch k jedné výšce</translation>
    </message>
    <message>
        <source>Evens out bumps; the volume stays</source>
        <translation>Vyrovnává hrboly; objem zůstává</translation>
    </message>
    <message>
        <source>Adds hills and hollows</source>
        <translation>Přidává kopečky a dolíky</translation>
    </message>
    <message>
        <source>Makes an even slope from where you press to where you let go</source>
        <translation>Vytvoří rovnoměrný svah od místa stisku k místu uvolnění</translation>
    </message>
    <message>
        <source>Brings back the ground as it was at the chosen moment</source>
        <translation>Vrací povrch do stavu ve zvoleném okamžiku</translation>
    </message>
    <message>
        <source>Adds exactly this much material with each stamp</source>
        <translation>Každým razítkem přidá přesně tolik materiálu</translation>
    </message>
    <message>
        <source>Takes material out and says how much</source>
        <translation>Odebírá materiál a říká, kolik</translation>
    </message>
    <message>
        <source>Fixes edges of the surface along your line</source>
        <translation>Upevní hrany povrchu podél vaší čáry</translation>
    </message>
    <message>
        <source>Wets or dries the surface; wet material stands at other slopes</source>
        <translation>Zvlhčuje nebo vysušuje povrch; vlhký materiál drží jiný sklon</translation>
    </message>
</context>
<context>
    <name>ToolFields</name>
    <message>
        <source>Level</source>
        <translation>Výška hladiny</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Poloměr</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Síla</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Objem</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Hloubka</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Kruh</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Čtverec</translation>
    </message>
    <message>
        <source>Wedge</source>
        <translation>Klín</translation>
    </message>
    <message>
        <source>Own outline</source>
        <translation>Vlastní obrys</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Tvar</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Natočení</translation>
    </message>
    <message>
        <source>Follow the stroke</source>
        <translation>Natáčet podle tahu</translation>
    </message>
    <message>
        <source>Press to a fixed level</source>
        <translation>Tlačit do pevné výšky</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Stěna</translation>
    </message>
    <message>
        <source>radii</source>
        <translation>poloměru</translation>
    </message>
    <message>
        <source>How far the sole&apos;s edge lies inside the outline</source>
        <translation>Jak daleko leží okraj dna uvnitř obrysu</translation>
    </message>
    <message>
        <source>Rim as the material makes it</source>
        <translation>Val podle materiálu</translation>
    </message>
    <message>
        <source>Rim angle</source>
        <translation>Úhel valu</translation>
    </message>
    <message>
        <source>Compression</source>
        <translation>Stlačení</translation>
    </message>
    <message>
        <source>The part of what is displaced that is pressed together</source>
        <translation>Část vytlačeného materiálu, která se stlačí</translation>
    </message>
    <message>
        <source>Pen pressure: depth</source>
        <translation>Přítlak pera: hloubka</translation>
    </message>
    <message>
        <source>Falloff</source>
        <translation>Útlum</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Stálý</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Lineární</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Hladký</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Koule</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Hrot</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Podrobnost</translation>
    </message>
    <message>
        <source>Vertices are added where they are farther apart</source>
        <translation>Kde jsou vrcholy dál od sebe, přidají se další</translation>
    </message>
    <message>
        <source>Pen pressure: radius</source>
        <translation>Přítlak pera: poloměr</translation>
    </message>
    <message>
        <source>Pen pressure: strength</source>
        <translation>Přítlak pera: síla</translation>
    </message>
    <message>
        <source>Tines</source>
        <translation>Počet hrotů</translation>
    </message>
    <message>
        <source>To a fixed level</source>
        <translation>Na pevnou výšku</translation>
    </message>
    <message>
        <source>Wavelength</source>
        <translation>Vlnová délka</translation>
    </message>
    <message>
        <source>Octaves</source>
        <translation>Oktávy</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semínko</translation>
    </message>
    <message>
        <source>Fixed start</source>
        <translation>Pevný začátek</translation>
    </message>
    <message>
        <source>Fixed end</source>
        <translation>Pevný konec</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>Vlhkost</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Rozestup</translation>
    </message>
    <message>
        <source>Of its vertices; 0: only the corners of your line</source>
        <translation>Vrcholů čáry; 0: jen v jejích rozích</translation>
    </message>
    <message>
        <source>At a fixed level</source>
        <translation>V pevné výšce</translation>
    </message>
    <message>
        <source>Where lines cross</source>
        <translation>Při křížení</translation>
    </message>
    <message>
        <source>Refuse</source>
        <translation>Odmítnout</translation>
    </message>
    <message>
        <source>Replace the other</source>
        <translation>Nahradit druhou</translation>
    </message>
    <message>
        <source>Join both</source>
        <translation>Spojit obě</translation>
    </message>
    <message>
        <source>Slope from</source>
        <translation>Sklon od</translation>
    </message>
    <message>
        <source>Slope to</source>
        <translation>Sklon do</translation>
    </message>
    <message>
        <source>Height from</source>
        <translation>Výška od</translation>
    </message>
    <message>
        <source>Height to</source>
        <translation>Výška do</translation>
    </message>
    <message>
        <source>Soft edge, slope</source>
        <translation>Měkký okraj, sklon</translation>
    </message>
    <message>
        <source>Soft edge, height</source>
        <translation>Měkký okraj, výška</translation>
    </message>
</context>
<context>
    <name>ToolPreset</name>
    <message>
        <source>Finger</source>
        <translation>Prst</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Dlaň</translation>
    </message>
    <message>
        <source>Plough</source>
        <translation>Pluh</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Krabice</translation>
    </message>
    <message>
        <source>Garden Rake</source>
        <translation>Zahradní hrábě</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Hřeben</translation>
    </message>
    <message>
        <source>Small Dunes</source>
        <translation>Malé duny</translation>
    </message>
</context>
<context>
    <name>Undo</name>
    <message>
        <source>Remove Normalisation</source>
        <translation>Zrušit normalizaci</translation>
    </message>
    <message>
        <source>Normalise Animation</source>
        <translation>Normalizovat animaci</translation>
    </message>
    <message>
        <source>Rename Animation</source>
        <translation>Přejmenovat animaci</translation>
    </message>
    <message>
        <source>Resample to %1 fps</source>
        <translation>Převzorkovat na %1 sn./s</translation>
    </message>
    <message>
        <source>Reverse Animation</source>
        <translation>Obrátit animaci</translation>
    </message>
    <message>
        <source>Set Basis Size to %1</source>
        <translation>Nastavit velikost báze na %1</translation>
    </message>
    <message>
        <source>Set Resolution to %1</source>
        <translation>Nastavit rozlišení na %1</translation>
    </message>
    <message>
        <source>Change Compression</source>
        <translation>Změnit kompresi</translation>
    </message>
    <message>
        <source>Play at %1 fps</source>
        <translation>Přehrávat rychlostí %1 sn./s</translation>
    </message>
    <message numerus="yes">
        <source>Trim to %n Frame(s)</source>
        <translation>
            <numerusform>Oříznout na %n snímek</numerusform>
            <numerusform>Oříznout na %n snímky</numerusform>
            <numerusform>Oříznout na %n snímků</numerusform>
        </translation>
    </message>
    <message>
        <source>Set Step to %1</source>
        <translation>Nastavit krok na %1</translation>
    </message>
    <message>
        <source>Set Basis Step to %1</source>
        <translation>Nastavit krok báze na %1</translation>
    </message>
    <message>
        <source>Add Material</source>
        <translation>Přidat materiál</translation>
    </message>
    <message>
        <source>Remove Material %1</source>
        <translation>Odebrat materiál %1</translation>
    </message>
    <message>
        <source>Change Material %1</source>
        <translation>Změnit materiál %1</translation>
    </message>
    <message>
        <source>Settle</source>
        <translation>Nechat ustálit</translation>
    </message>
    <message>
        <source>Remove Layer</source>
        <translation>Odebrat vrstvu</translation>
    </message>
    <message>
        <source>Add Layer</source>
        <translation>Přidat vrstvu</translation>
    </message>
    <message>
        <source>Fill Layer</source>
        <translation>Vyplnit vrstvu</translation>
    </message>
    <message>
        <source>Change Layer&apos;s Material</source>
        <translation>Změnit materiál vrstvy</translation>
    </message>
    <message>
        <source>Let Sand Slide</source>
        <translation>Nechat písek sesouvat</translation>
    </message>
    <message>
        <source>Let Sand Slide One Step</source>
        <translation>Nechat písek sesunout o krok</translation>
    </message>
    <message>
        <source>Clear Mask</source>
        <translation>Smazat masku</translation>
    </message>
    <message>
        <source>Invert Mask</source>
        <translation>Obrátit masku</translation>
    </message>
    <message>
        <source>Erase Mask</source>
        <translation>Mazat masku</translation>
    </message>
    <message>
        <source>Paint Mask</source>
        <translation>Malovat masku</translation>
    </message>
    <message>
        <source>Fill Holes</source>
        <translation>Zaplnit díry</translation>
    </message>
    <message>
        <source>Cut Handle</source>
        <translation>Rozříznout ucho</translation>
    </message>
    <message>
        <source>Delete Components</source>
        <translation>Odstranit komponenty</translation>
    </message>
    <message>
        <source>Weld Vertices</source>
        <translation>Svařit vrcholy</translation>
    </message>
    <message>
        <source>Orient Faces</source>
        <translation>Sjednotit orientaci stěn</translation>
    </message>
    <message>
        <source>Remove Degenerate Faces</source>
        <translation>Odstranit degenerované stěny</translation>
    </message>
    <message>
        <source>Remove Duplicate Faces</source>
        <translation>Odstranit opakované stěny</translation>
    </message>
    <message>
        <source>Remove Isolated Vertices</source>
        <translation>Odstranit izolované vrcholy</translation>
    </message>
    <message>
        <source>Split Non-Manifold Parts</source>
        <translation>Rozdělit nevariety</translation>
    </message>
    <message>
        <source>Halve the Triangles</source>
        <translation>Zmenšit počet trojúhelníků na polovinu</translation>
    </message>
    <message>
        <source>Subdivide</source>
        <translation>Dělit trojúhelníky</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Vyhladit</translation>
    </message>
</context>
<context>
    <name>editor::CompareActions</name>
    <message>
        <source>The animation cannot be compared with %1.</source>
        <translation>Animaci nelze porovnat s %1.</translation>
    </message>
</context>
<context>
    <name>editor::Document</name>
    <message>
        <source>Sample, not saved to a file yet</source>
        <translation>Ukázka, zatím neuložená do souboru</translation>
    </message>
</context>
<context>
    <name>editor::DocumentTab</name>
    <message>
        <source>Opening %1…</source>
        <translation>Otevírá se %1…</translation>
    </message>
    <message>
        <source>Progress of opening</source>
        <translation>Průběh otevírání</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
</context>
<context>
    <name>editor::DropTarget</name>
    <message>
        <source>Drop to open</source>
        <translation>Puštěním otevřete</translation>
    </message>
</context>
<context>
    <name>editor::Feeling</name>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Stop all forces</source>
        <translation>Vypnout všechny síly</translation>
    </message>
    <message>
        <source>Forces off, at once (Escape)</source>
        <translation>Okamžitě vypne síly (Escape)</translation>
    </message>
</context>
<context>
    <name>editor::FileActions</name>
    <message>
        <source>%1 cannot be opened.</source>
        <translation>%1 nelze otevřít.</translation>
    </message>
    <message>
        <source>File Changed</source>
        <translation>Soubor se změnil</translation>
    </message>
    <message>
        <source>Another program has changed %1 since it was opened.</source>
        <translation>Soubor %1 byl od otevření změněn jiným programem.</translation>
    </message>
    <message>
        <source>Saving replaces those changes by yours.</source>
        <translation>Uložením tyto změny nahradíte svými.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Nahradit</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Načíst znovu</translation>
    </message>
    <message>
        <source>Reloading drops the unsaved changes of %1.</source>
        <translation>Opětovným načtením se zahodí neuložené změny animace %1.</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Neuložené změny</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>Animace %1 má neuložené změny.</translation>
    </message>
    <message>
        <source>&amp;Save All</source>
        <translation>&amp;Uložit vše</translation>
    </message>
    <message>
        <source>&amp;Discard All</source>
        <translation>&amp;Zahodit vše</translation>
    </message>
    <message>
        <source>Saved %1 (%2)</source>
        <translation>Uloženo %1 (%2)</translation>
    </message>
    <message>
        <source>%1 was not saved.</source>
        <translation>Soubor %1 nebyl uložen.</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otevřít</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>Uložit jako</translation>
    </message>
    <message numerus="yes">
        <source>%n document(s) have unsaved changes.</source>
        <translation>
            <numerusform>%n dokument má neuložené změny.</numerusform>
            <numerusform>%n dokumenty mají neuložené změny.</numerusform>
            <numerusform>%n dokumentů má neuložené změny.</numerusform>
        </translation>
    </message>
    <message>
        <source>Opened %1: %2</source>
        <translation>Otevřeno %1; %2</translation>
    </message>
    <message>
        <source>What happens to %1 is not being recorded: it would not come back after a crash.</source>
        <translation>Změny dokumentu %1 se nezaznamenávají: po pádu programu by se nevrátily.</translation>
    </message>
    <message>
        <source>Everything that can be opened (%1)</source>
        <translation>Vše, co lze otevřít (%1)</translation>
    </message>
</context>
<context>
    <name>editor::HelpActions</name>
    <message>
        <source>Mouse in the Picture</source>
        <translation>Myš v obraze</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Otáčení</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Tažení levým tlačítkem</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Posun</translation>
    </message>
    <message>
        <source>Middle drag, or Shift+left drag</source>
        <translation>Tažení prostředním, nebo Shift a levým tlačítkem</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Přiblížení</translation>
    </message>
    <message>
        <source>Wheel, or right drag</source>
        <translation>Kolečko, nebo tažení pravým tlačítkem</translation>
    </message>
    <message>
        <source>Close a tab</source>
        <translation>Zavření karty</translation>
    </message>
    <message>
        <source>Middle click on it</source>
        <translation>Kliknutí prostředním tlačítkem na kartu</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Klávesové zkratky</translation>
    </message>
    <message>
        <source>Sandreel is free software under the GNU General Public License, version 3 or later. It is made with these libraries:</source>
        <translation>Sandreel je svobodný software pod licencí GNU General Public License verze 3 nebo novější. Používá tyto knihovny:</translation>
    </message>
    <message>
        <source>Licences</source>
        <translation>Licence</translation>
    </message>
    <message>
        <source>About Sandreel</source>
        <translation>O programu Sandreel</translation>
    </message>
    <message>
        <source>Prepares, opens and plays mesh animations.</source>
        <translation>Připravuje, otevírá a přehrává animace sítí.</translation>
    </message>
    <message>
        <source>Qt %1</source>
        <translation>Qt %1</translation>
    </message>
    <message>
        <source>No OpenGL</source>
        <translation>Bez OpenGL</translation>
    </message>
    <message>
        <source>OpenGL %1</source>
        <translation>OpenGL %1</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. It comes without any warranty.</source>
        <translation>Svobodný software pod licencí GNU General Public License verze 3 nebo novější. Poskytuje se bez jakékoli záruky.</translation>
    </message>
</context>
<context>
    <name>editor::Inspector</name>
    <message>
        <source>Mesh View %1</source>
        <translation>Pohled na síť %1</translation>
    </message>
    <message>
        <source>%1, frame %2</source>
        <translation>%1, snímek %2</translation>
    </message>
    <message>
        <source>The list that is open, as CSV (*.csv)</source>
        <translation>Otevřený seznam jako CSV (*.csv)</translation>
    </message>
    <message>
        <source>Save Report</source>
        <translation>Uložit zprávu</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>Zpráva je v souboru %1.</translation>
    </message>
    <message>
        <source>%1 was not saved.</source>
        <translation>Soubor %1 nebyl uložen.</translation>
    </message>
</context>
<context>
    <name>editor::MainWindow</name>
    <message>
        <source>File Toolbar</source>
        <translation>Panel souboru</translation>
    </message>
    <message>
        <source>Edit Toolbar</source>
        <translation>Panel úprav</translation>
    </message>
    <message>
        <source>View Toolbar</source>
        <translation>Panel zobrazení</translation>
    </message>
</context>
<context>
    <name>editor::MeshActions</name>
    <message>
        <source>%1 was left as it is.</source>
        <translation>%1: beze změny.</translation>
    </message>
    <message>
        <source>It is no oriented manifold: orient its faces and split its non-manifold parts first.</source>
        <translation>Není to orientovaná varieta: nejprve sjednoťte orientaci stěn a rozdělte nevariety.</translation>
    </message>
    <message>
        <source>The loop does not run along edges of two faces.</source>
        <translation>Smyčka nevede po hranách dvou stěn.</translation>
    </message>
    <message>
        <source>The loop touches holes on both sides: fill them first.</source>
        <translation>Smyčka se na obou stranách dotýká děr: nejprve je zaplňte.</translation>
    </message>
    <message>
        <source>%1: there is nothing to do.</source>
        <translation>%1: není co dělat.</translation>
    </message>
</context>
<context>
    <name>editor::MeshTab</name>
    <message>
        <source>This machine has no OpenGL 3.3, so the mesh cannot be drawn. The inspector lists what it is made of all the same.</source>
        <translation>Tento počítač nemá OpenGL 3.3, takže síť nelze nakreslit. Inspektor přesto vypíše, z čeho se skládá.</translation>
    </message>
</context>
<context>
    <name>editor::OpenAnimation</name>
    <message>
        <source>%1 (cut)</source>
        <translation>%1 (neúplné)</translation>
    </message>
    <message>
        <source>What is there of a file that was cut, not saved to a file yet</source>
        <translation>To, co je k dispozici z neúplného souboru, zatím neuložené do souboru</translation>
    </message>
    <message>
        <source>%L1 vertices, %L2 frames</source>
        <translation>vrcholů: %L1, snímků: %L2</translation>
    </message>
    <message>
        <source>%1: the file ends too early. Shown are %2 of its %3 details. Copy it again, or save what is there under another name.</source>
        <translation>%1: soubor končí příliš brzy. Počet zobrazených detailů: %2 z %3. Zkopírujte jej znovu, nebo uložte to, co je k dispozici, pod jiným názvem.</translation>
    </message>
    <message>
        <source>Recorded, not saved to a file yet</source>
        <translation>Nahráno, zatím neuloženo do souboru</translation>
    </message>
</context>
<context>
    <name>editor::OpenMesh</name>
    <message>
        <source>Made of an animation, not saved to a file yet</source>
        <translation>Vytvořeno z animace, zatím neuloženo do souboru</translation>
    </message>
    <message>
        <source>%L1 vertices, %L2 faces</source>
        <translation>vrcholů: %L1, stěn: %L2</translation>
    </message>
    <message numerus="yes">
        <source>It is one of %n numbered meshes in its folder. To open them as an animation, drop the folder here, or choose it in File &gt; Prepare Animation.</source>
        <translation>
            <numerusform>Je to jedna z %n očíslované sítě ve složce. Chcete-li je otevřít jako animaci, přetáhněte sem složku, nebo ji vyberte v nabídce Soubor &gt; Připravit animaci.</numerusform>
            <numerusform>Je to jedna ze %n očíslovaných sítí ve složce. Chcete-li je otevřít jako animaci, přetáhněte sem složku, nebo ji vyberte v nabídce Soubor &gt; Připravit animaci.</numerusform>
            <numerusform>Je to jedna z %n očíslovaných sítí ve složce. Chcete-li je otevřít jako animaci, přetáhněte sem složku, nebo ji vyberte v nabídce Soubor &gt; Připravit animaci.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>editor::OpenTerrain</name>
    <message>
        <source>New, not saved to a file yet</source>
        <translation>Nový, zatím neuložený do souboru</translation>
    </message>
    <message>
        <source>Imported, not saved to a file yet</source>
        <translation>Importovaný, zatím neuložený do souboru</translation>
    </message>
    <message>
        <source>Recovered, not saved to a file yet</source>
        <translation>Obnovený, zatím neuložený do souboru</translation>
    </message>
    <message>
        <source>%L1 vertices, %L2 triangles</source>
        <translation>vrcholů: %L1, trojúhelníků: %L2</translation>
    </message>
    <message>
        <source>%1 is open elsewhere too: %2. Whoever saves last replaces what the other saved.</source>
        <translation>%1 je otevřen i jinde: %2. Kdo uloží poslední, nahradí to, co uložil ten druhý.</translation>
    </message>
    <message>
        <source>%1 is of a newer Sandreel. Saving it here may lose what this one does not know.</source>
        <translation>%1 je z novější verze Sandreelu. Uložením zde se může ztratit to, co tato verze nezná.</translation>
    </message>
</context>
<context>
    <name>editor::RecordActions</name>
    <message>
        <source>Recording %1: heights at %L2 × %L3 places, up to %L4 frames (%5 of memory). Record again to stop.</source>
        <translation>Nahrává se %1: výšky na %L2 × %L3 místech, nejvýše %L4 snímků (%5 paměti). Ukončíte opět příkazem Nahrávat.</translation>
    </message>
    <message numerus="yes">
        <source>Recording %1: %n frame(s)</source>
        <translation>
            <numerusform>Nahrává se %1: %n snímek</numerusform>
            <numerusform>Nahrává se %1: %n snímky</numerusform>
            <numerusform>Nahrává se %1: %n snímků</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 in motion</source>
        <translation>%1 v pohybu</translation>
    </message>
    <message>
        <source>Nothing happened to %1 that could be shown.</source>
        <translation>S dokumentem %1 se nestalo nic, co by šlo ukázat.</translation>
    </message>
    <message>
        <source>The recording ended at its limit of %L1 frames.</source>
        <translation>Nahrávání skončilo na své mezi %L1 snímků.</translation>
    </message>
</context>
<context>
    <name>editor::RecoveryDialog</name>
    <message>
        <source>Recover Terrains</source>
        <translation>Obnovit terény</translation>
    </message>
    <message>
        <source>Sandreel ended without saving these terrains. They can be opened as they were.</source>
        <translation>Sandreel skončil, aniž by tyto terény uložil. Lze je otevřít tak, jak byly.</translation>
    </message>
    <message>
        <source>Terrains that were not saved</source>
        <translation>Neuložené terény</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Obnovit</translation>
    </message>
    <message>
        <source>&amp;Discard…</source>
        <translation>&amp;Zahodit…</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>&amp;Později</translation>
    </message>
    <message>
        <source>They are offered again at the next start</source>
        <translation>Při příštím spuštění budou nabídnuty znovu</translation>
    </message>
    <message>
        <source>Without a name</source>
        <translation>Beze jména</translation>
    </message>
    <message>
        <source>Never saved to a file</source>
        <translation>Nikdy neuloženo do souboru</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Zahodit</translation>
    </message>
    <message numerus="yes">
        <source>%n terrain(s) cannot be recovered any more after this.</source>
        <translation>
            <numerusform>%n terén už potom nepůjde obnovit.</numerusform>
            <numerusform>%n terény už potom nepůjde obnovit.</numerusform>
            <numerusform>%n terénů už potom nepůjde obnovit.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>editor::Sandbox</name>
    <message>
        <source>Took out %1</source>
        <translation>Nabráno %1</translation>
    </message>
</context>
<context>
    <name>editor::ShortcutDialog</name>
    <message>
        <source>&amp;Assign</source>
        <translation>&amp;Přiřadit</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>&amp;Odebrat</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>&amp;Výchozí</translation>
    </message>
    <message>
        <source>Configure Shortcuts</source>
        <translation>Nastavit zkratky</translation>
    </message>
    <message>
        <source>Search actions or keys</source>
        <translation>Hledat akce nebo klávesy</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Hledat</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Akce</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Zkratka</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Akce</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>Nová zkratka</translation>
    </message>
    <message>
        <source>Press the keys</source>
        <translation>Stiskněte klávesy</translation>
    </message>
    <message>
        <source>&amp;New shortcut:</source>
        <translation>&amp;Nová zkratka:</translation>
    </message>
    <message>
        <source>Default for A&amp;ll</source>
        <translation>Výchozí pro &amp;všechny</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>&amp;Take Over</source>
        <translation>P&amp;řevzít</translation>
    </message>
    <message>
        <source>%1 already belongs to %2, which would lose it.</source>
        <translation>%1 už patří akci %2, která by zkratku ztratila.</translation>
    </message>
    <message>
        <source>Some default keys belong to other actions now and stay there.</source>
        <translation>Některé výchozí klávesy teď patří jiným akcím a zůstávají u nich.</translation>
    </message>
</context>
<context>
    <name>editor::StatusPanel</name>
    <message>
        <source>Drag: orbit   Shift+drag: pan   Wheel: zoom   Space: play</source>
        <translation>Tažení: otáčení   Shift+tažení: posun   Kolečko: přiblížení   Mezerník: přehrávání</translation>
    </message>
    <message>
        <source>V %1</source>
        <comment>number of vertices</comment>
        <translation>V %1</translation>
    </message>
    <message>
        <source>T %1</source>
        <comment>number of triangles</comment>
        <translation>T %1</translation>
    </message>
    <message>
        <source>F %1</source>
        <comment>number of frames</comment>
        <translation>S %1</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 sn./s</translation>
    </message>
    <message>
        <source>Vertices, triangles, frames, frame rate, size of the file</source>
        <translation>Vrcholy, trojúhelníky, snímky, snímková frekvence, velikost souboru</translation>
    </message>
    <message>
        <source>Drop an animation, a terrain, a folder of meshes, a scene or an elevation model here</source>
        <translation>Sem přetáhněte animaci, terén, složku sítí, scénu nebo výškový model</translation>
    </message>
    <message>
        <source>%1 × %2 m</source>
        <translation>%1 × %2 m</translation>
    </message>
    <message>
        <source>Vertices, triangles, width and depth, size of the file</source>
        <translation>Vrcholy, trojúhelníky, šířka a hloubka, velikost souboru</translation>
    </message>
    <message>
        <source>Drag: draw   Right drag: orbit   Wheel: zoom   F: radius   Shift+F: strength</source>
        <translation>Tažení: kreslení   Pravé tlačítko: otáčení   Kolečko: přiblížení   F: poloměr   Shift+F: síla</translation>
    </message>
    <message>
        <source>x %1 m   y %2 m   height %3 m</source>
        <translation>x %1 m   y %2 m   výška %3 m</translation>
    </message>
    <message>
        <source>slope %1°</source>
        <translation>sklon %1°</translation>
    </message>
    <message>
        <source>humidity %1</source>
        <translation>vlhkost %1</translation>
    </message>
    <message>
        <source>F %1</source>
        <comment>number of faces</comment>
        <translation>S %1</translation>
    </message>
    <message>
        <source>Vertices, faces, size of the file</source>
        <translation>Vrcholy, stěny, velikost souboru</translation>
    </message>
    <message>
        <source>Click: pick   Drag: orbit   Shift+drag: pan   Wheel: zoom</source>
        <translation>Kliknutí: výběr   Tažení: otáčení   Shift+tažení: posun   Kolečko: přiblížení</translation>
    </message>
</context>
<context>
    <name>editor::ViewActions</name>
    <message>
        <source>Density of the points</source>
        <translation>Hustota bodů</translation>
    </message>
    <message>
        <source>Share of the vertices that are drawn as points</source>
        <translation>Podíl vrcholů kreslených jako body</translation>
    </message>
</context>
<context>
    <name>editor::WelcomePage</name>
    <message>
        <source>Samples</source>
        <translation>Ukázky</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Nedávné</translation>
    </message>
    <message>
        <source>Mesh animations and sandy terrain</source>
        <translation>Animace sítí a písčitý terén</translation>
    </message>
    <message>
        <source>You can also drop files here: an .anim or .terrain file, a folder of OBJ, OFF, PLY or STL meshes, a PC2 or MDD point cache, a glTF or FBX scene, or an elevation model.</source>
        <translation>Soubory sem můžete také přetáhnout: soubor .anim nebo .terrain, složku sítí OBJ, OFF, PLY nebo STL, mezipaměť bodů PC2 nebo MDD, scénu glTF nebo FBX, nebo výškový model.</translation>
    </message>
</context>
<context>
    <name>editor::Workspace</name>
    <message>
        <source>Has unsaved changes</source>
        <translation>Má neuložené změny</translation>
    </message>
    <message>
        <source>Open documents</source>
        <translation>Otevřené dokumenty</translation>
    </message>
</context>
<context>
    <name>views::AnimationViewport</name>
    <message>
        <source>Animation</source>
        <translation>Animace</translation>
    </message>
    <message>
        <source>The mesh in 3D. Arrow keys turn it, plus and minus zoom, F shows all of it.</source>
        <translation>Síť v prostoru. Šipky ji otáčejí, plus a minus přibližují a oddalují, F ji ukáže celou.</translation>
    </message>
</context>
<context>
    <name>views::CompareDialog</name>
    <message>
        <source>Original</source>
        <translation>Originál</translation>
    </message>
    <message>
        <source>Compare %1 with Its Original</source>
        <translation>Porovnat %1 s originálem</translation>
    </message>
    <message>
        <source>A File or Folder</source>
        <translation>Soubor nebo složka</translation>
    </message>
    <message>
        <source>As was done when the animation was prepared: the original is moved and scaled alike</source>
        <translation>Jako při přípravě animace: originál se posune a zvětší stejně</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Porovnat</translation>
    </message>
    <message>
        <source>&amp;Original:</source>
        <translation>&amp;Originál:</translation>
    </message>
    <message>
        <source>&amp;Path:</source>
        <translation>&amp;Cesta:</translation>
    </message>
    <message>
        <source>&amp;Normalise it:</source>
        <translation>&amp;Normalizovat jej:</translation>
    </message>
    <message>
        <source>Frames and vertices must be as many, and in the same order.</source>
        <translation>Snímků a vrcholů musí být stejně, ve stejném pořadí.</translation>
    </message>
</context>
<context>
    <name>views::CompressionDock</name>
    <message>
        <source>Compression</source>
        <translation>Komprese</translation>
    </message>
    <message>
        <source>When Saved</source>
        <translation>Při uložení</translation>
    </message>
    <message>
        <source>&amp;Measure Size and Error</source>
        <translation>&amp;Změřit velikost a chybu</translation>
    </message>
    <message>
        <source>Compress with these settings, without saving, and compare the result with the animation</source>
        <translation>Zkomprimovat s tímto nastavením bez uložení a porovnat výsledek s animací</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Měření…</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Soubor</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Velikost:</translation>
    </message>
    <message>
        <source>As float32:</source>
        <translation>Jako float32:</translation>
    </message>
    <message>
        <source>Ratio:</source>
        <translation>Poměr:</translation>
    </message>
    <message>
        <source>Bits per V × F:</source>
        <translation>Bitů na V × S:</translation>
    </message>
    <message>
        <source>Basis vectors:</source>
        <translation>Vektorů báze:</translation>
    </message>
    <message>
        <source>Written by:</source>
        <translation>Zapsal:</translation>
    </message>
    <message>
        <source>Bits for each vertex of each frame, everything in the file included</source>
        <translation>Bity na každý vrchol každého snímku, počítáno vše, co je v souboru</translation>
    </message>
    <message>
        <source>Basis vectors kept; an animation of lower rank keeps fewer than asked for</source>
        <translation>Počet zachovaných vektorů báze; animace nižší hodnosti jich zachová méně, než bylo požadováno</translation>
    </message>
    <message>
        <source>Parts of the file</source>
        <translation>Části souboru</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Část</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bajty</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Podíl</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1, ratio %2, %3 bits per vertex and frame
KG error %4 %, RMSE %5, largest error %6</source>
        <translation>%1, poměr %2, %3 bitu na vrchol a snímek
Chyba KG %4 %, RMSE %5, největší chyba %6</translation>
    </message>
</context>
<context>
    <name>views::CompressionFields</name>
    <message>
        <source>Codec</source>
        <translation>Kodek</translation>
    </message>
    <message>
        <source>&amp;Codec:</source>
        <translation>&amp;Kodek:</translation>
    </message>
    <message>
        <source>&amp;Basis size:</source>
        <translation>Velikost &amp;báze:</translation>
    </message>
    <message>
        <source>Basis size</source>
        <translation>Velikost báze</translation>
    </message>
    <message>
        <source>more: larger and more exact</source>
        <translation>více: větší a přesnější</translation>
    </message>
    <message>
        <source>Number of movements that the animation is put together from.</source>
        <translation>Počet pohybů, ze kterých se animace skládá.</translation>
    </message>
    <message>
        <source>&amp;Resolution:</source>
        <translation>&amp;Rozlišení:</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Rozlišení</translation>
    </message>
    <message>
        <source>steps per unit of length</source>
        <translation>kroků na jednotku délky</translation>
    </message>
    <message>
        <source>How finely numbers are rounded. Normalise, so that it means the same for every animation.</source>
        <translation>Jak jemně se čísla zaokrouhlují. Po normalizaci znamená pro každou animaci totéž.</translation>
    </message>
    <message>
        <source>PCA</source>
        <translation>PCA</translation>
    </message>
    <message>
        <source>Direct</source>
        <translation>Direct</translation>
    </message>
    <message>
        <source>CoDDyaC</source>
        <translation>CoDDyaC</translation>
    </message>
    <message>
        <source>Reel</source>
        <translation>Reel</translation>
    </message>
    <message>
        <source>basis %1</source>
        <translation>báze %1</translation>
    </message>
    <message>
        <source>resolution %1</source>
        <translation>rozlišení %1</translation>
    </message>
    <message>
        <source>0: as many as pay</source>
        <translation>0: kolik se vyplatí</translation>
    </message>
    <message>
        <source>cells along the longest side</source>
        <translation>buněk podél nejdelší strany</translation>
    </message>
    <message>
        <source>No vertex is farther off than half the diagonal of a cell.</source>
        <translation>Žádný vrchol není dál než půl úhlopříčky buňky.</translation>
    </message>
    <message>
        <source>St&amp;ep:</source>
        <translation>Kr&amp;ok:</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Krok</translation>
    </message>
    <message>
        <source>less: larger and more exact</source>
        <translation>méně: větší a přesnější</translation>
    </message>
    <message>
        <source>How finely the movements&apos; shares are rounded, relative to their mean size.</source>
        <translation>Jak jemně se zaokrouhlují podíly pohybů, vzhledem k jejich střední velikosti.</translation>
    </message>
    <message>
        <source>Basis s&amp;tep:</source>
        <translation>Krok báz&amp;e:</translation>
    </message>
    <message>
        <source>Basis step</source>
        <translation>Krok báze</translation>
    </message>
    <message>
        <source>How finely the movements themselves are rounded.</source>
        <translation>Jak jemně se zaokrouhlují samotné pohyby.</translation>
    </message>
    <message>
        <source>&amp;Prediction:</source>
        <translation>&amp;Předpověď:</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>Předpověď</translation>
    </message>
    <message>
        <source>What a vertex is expected to do: the better the guess, the smaller the file.</source>
        <translation>Co se od vrcholu čeká: čím lepší odhad, tím menší soubor.</translation>
    </message>
    <message>
        <source>Packin&amp;g:</source>
        <translation>&amp;Balení:</translation>
    </message>
    <message>
        <source>Packing</source>
        <translation>Balení</translation>
    </message>
    <message>
        <source>How the differences from what was expected are packed.</source>
        <translation>Jak se balí rozdíly od toho, co se čekalo.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Žádná</translation>
    </message>
    <message>
        <source>A: stays where it was</source>
        <translation>A: zůstane, kde byl</translation>
    </message>
    <message>
        <source>B: goes on as it moved</source>
        <translation>B: pokračuje, jak se pohyboval</translation>
    </message>
    <message>
        <source>C: goes on as it accelerated</source>
        <translation>C: pokračuje, jak zrychloval</translation>
    </message>
    <message>
        <source>N: moves with its neighbours</source>
        <translation>N: pohne se se sousedy</translation>
    </message>
    <message>
        <source>Deflate</source>
        <translation>Deflate</translation>
    </message>
    <message>
        <source>Range coder</source>
        <translation>Intervalový kodér</translation>
    </message>
    <message>
        <source>prediction %1</source>
        <translation>předpověď %1</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>krok %1</translation>
    </message>
    <message>
        <source>basis step %1</source>
        <translation>krok báze %1</translation>
    </message>
    <message>
        <source>Keep the order of the &amp;vertices</source>
        <translation>Zachovat pořadí &amp;vrcholů</translation>
    </message>
    <message>
        <source>Without it the file is a little smaller, and vertices are numbered anew.</source>
        <translation>Bez toho je soubor o něco menší a vrcholy se očíslují znovu.</translation>
    </message>
</context>
<context>
    <name>views::ErosionDock</name>
    <message>
        <source>Erosion</source>
        <translation>Eroze</translation>
    </message>
    <message>
        <source>Slide &amp;while drawing</source>
        <translation>Sesouvat &amp;při kreslení</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Krok</translation>
    </message>
    <message>
        <source>Go once over everything that is too steep</source>
        <translation>Projít jednou vše, co je příliš strmé</translation>
    </message>
    <message>
        <source>&amp;Until Settled</source>
        <translation>Až do &amp;ustálení</translation>
    </message>
    <message>
        <source>Let everything slide in the background, until no face is too steep</source>
        <translation>Nechat vše sesouvat na pozadí, dokud bude některý trojúhelník příliš strmý</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Nyní</translation>
    </message>
    <message>
        <source>Active triangles:</source>
        <translation>Aktivní trojúhelníky:</translation>
    </message>
    <message>
        <source>Moving:</source>
        <translation>Sesouvá se:</translation>
    </message>
    <message>
        <source>Moved:</source>
        <translation>Sesunuto:</translation>
    </message>
    <message>
        <source>Steepest face:</source>
        <translation>Nejstrmější:</translation>
    </message>
    <message>
        <source>Volume drift:</source>
        <translation>Odchylka objemu:</translation>
    </message>
    <message>
        <source>Volume that the ledger does not explain, as a part of the whole</source>
        <translation>Objem, který účetnictví nevysvětluje, jako část celku</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Nastavení</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Trojúhelníky</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Hrany</translation>
    </message>
    <message>
        <source>Faces come to rest at the critical angle. Edges are the older rule: faces stay steeper.</source>
        <translation>Trojúhelníky se ustálí na kritickém úhlu. Hrany jsou starší pravidlo: trojúhelníky zůstávají strmější.</translation>
    </message>
    <message>
        <source>Rule:</source>
        <translation>Pravidlo:</translation>
    </message>
    <message>
        <source>Critical angle</source>
        <translation>Kritický úhel</translation>
    </message>
    <message>
        <source>Critical angle:</source>
        <translation>Kritický úhel:</translation>
    </message>
    <message>
        <source>from the materials</source>
        <translation>podle materiálů</translation>
    </message>
    <message>
        <source>Starts at:</source>
        <translation>Začíná při:</translation>
    </message>
    <message>
        <source>Degrees above the critical angle from which resting sand starts to slide</source>
        <translation>Stupně nad kritickým úhlem, od nichž se klidný písek začne sesouvat</translation>
    </message>
    <message>
        <source>Speed:</source>
        <translation>Rychlost:</translation>
    </message>
    <message>
        <source>Simulated seconds in a second</source>
        <translation>Simulovaných sekund za sekundu</translation>
    </message>
    <message>
        <source>Sweeps:</source>
        <translation>Průchody:</translation>
    </message>
    <message>
        <source>Over everything that may move, in a simulated second</source>
        <translation>Přes vše, co se může pohnout, za simulovanou sekundu</translation>
    </message>
    <message>
        <source>per s</source>
        <translation>za s</translation>
    </message>
    <message>
        <source>Over-relaxation:</source>
        <translation>Nadrelaxace:</translation>
    </message>
    <message>
        <source>Above 1, each step goes too far and all comes to rest sooner</source>
        <translation>Nad 1 jde každý krok dál, než je třeba, a vše se ustálí dřív</translation>
    </message>
    <message>
        <source>Longest edge:</source>
        <translation>Nejdelší hrana:</translation>
    </message>
    <message>
        <source>Longer ones are split before sand slides over them; 0: none</source>
        <translation>Delší se rozdělí, než se po nich písek sesune; 0: žádná</translation>
    </message>
    <message>
        <source>Vertical error:</source>
        <translation>Svislá chyba:</translation>
    </message>
    <message>
        <source>Vertices that are of no use are removed if the surface changes by no more; 0: none are</source>
        <translation>Zbytečné vrcholy se odeberou, pokud se povrch nezmění o více; 0: žádné</translation>
    </message>
    <message>
        <source>Redundancy angle:</source>
        <translation>Úhel nadbytečnosti:</translation>
    </message>
    <message>
        <source>Between the triangles around a vertex that may be of no use</source>
        <translation>Mezi trojúhelníky kolem vrcholu, který může být zbytečný</translation>
    </message>
    <message>
        <source>Time per frame:</source>
        <translation>Čas na snímek:</translation>
    </message>
    <message>
        <source>More slides sooner, less keeps the window quick</source>
        <translation>Víc sesune dřív, míň nechá okno svižné</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Settle on a coarse grid first</source>
        <translation>Ustálit nejprve na hrubé síti</translation>
    </message>
    <message>
        <source>A third faster; the tip of a heap ends a hundredth lower</source>
        <translation>O třetinu rychlejší; vrchol hromady skončí o setinu níž</translation>
    </message>
    <message>
        <source>Settling…</source>
        <translation>Ustaluje se…</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pozastavit</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Spustit</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
</context>
<context>
    <name>views::ErrorPanel</name>
    <message>
        <source>Not comparable with %1 now: %2</source>
        <translation>Teď nelze porovnat s %1: %2</translation>
    </message>
    <message>
        <source>Up to %1 in frame %2</source>
        <translation>Nejvýše %1 ve snímku %2</translation>
    </message>
    <message>
        <source>All frames together: %1 %</source>
        <translation>Všechny snímky dohromady: %1 %</translation>
    </message>
    <message>
        <source>Per cent of the diagonal of the original&apos;s box over all frames</source>
        <translation>Procenta úhlopříčky kvádru kolem všech snímků originálu</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <extracomment>%1: the name of the original</extracomment>
        <translation>Čte se %1…</translation>
    </message>
    <message>
        <source>Comparing with %1…</source>
        <translation>Porovnává se s %1…</translation>
    </message>
    <message>
        <source>%1 here, up to %2 in frame %3</source>
        <translation>zde %1, nejvýše %2 ve snímku %3</translation>
    </message>
    <message>
        <source>KG Error</source>
        <translation>Chyba KG</translation>
    </message>
    <message>
        <source>Largest Vertex Error</source>
        <translation>Největší chyba vrcholu</translation>
    </message>
    <message>
        <source>Error shown</source>
        <translation>Zobrazená chyba</translation>
    </message>
    <message>
        <source>KG: of all vertices of a frame together, against the frame&apos;s extent.
Largest: of the worst vertex, in per cent of the diagonal of the original&apos;s box.</source>
        <translation>KG: všech vrcholů snímku dohromady, vůči rozměru snímku.
Největší: nejhoršího vrcholu, v procentech úhlopříčky kvádru originálu.</translation>
    </message>
    <message>
        <source>Error of each frame</source>
        <translation>Chyba každého snímku</translation>
    </message>
    <message>
        <source>Progress of comparing</source>
        <translation>Průběh porovnání</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
</context>
<context>
    <name>views::ErrorPlot</name>
    <message>
        <source>Frame %1: %2 %3</source>
        <translation>Snímek %1: %2 %3</translation>
    </message>
</context>
<context>
    <name>views::ExportDialog</name>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportovat</translation>
    </message>
    <message>
        <source>Show in Folde&amp;r</source>
        <translation>Zobrazit ve slož&amp;ce</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Zapisuje se…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zavřít</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Zapsáno: %1</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was left behind.</source>
        <translation>Zrušeno. Nic po sobě nezanechal.</translation>
    </message>
    <message>
        <source>Already there: %1. Replace?</source>
        <translation>Už existuje: %1. Nahradit?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Nahradit</translation>
    </message>
</context>
<context>
    <name>views::ExportFramesDialog</name>
    <message>
        <source>Export Frames</source>
        <translation>Export snímků</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Složka</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formát</translation>
    </message>
    <message>
        <source>OBJ (text)</source>
        <translation>OBJ (textový)</translation>
    </message>
    <message>
        <source>OFF (text)</source>
        <translation>OFF (textový)</translation>
    </message>
    <message>
        <source>PLY (binary)</source>
        <translation>PLY (binární)</translation>
    </message>
    <message>
        <source>F&amp;older:</source>
        <translation>S&amp;ložka:</translation>
    </message>
    <message>
        <source>For&amp;mat:</source>
        <translation>For&amp;mát:</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>Zvolte složku.</translation>
    </message>
    <message>
        <source>The folder is a file.</source>
        <translation>To není složka, ale soubor.</translation>
    </message>
    <message>
        <source>The folder that shall hold the new folder does not exist.</source>
        <translation>Složka, ve které má nová složka vzniknout, neexistuje.</translation>
    </message>
    <message>
        <source>The folder holds frames already. Choose another one, so that they do not mix.</source>
        <translation>Ve složce už jsou snímky. Zvolte jinou, aby se nepomíchaly.</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) will be written.</source>
        <translation>
            <numerusform>Zapíše se %n soubor.</numerusform>
            <numerusform>Zapíšou se %n soubory.</numerusform>
            <numerusform>Zapíše se %n souborů.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>views::ExportPicturesDialog</name>
    <message>
        <source>Export Pictures</source>
        <translation>Export obrázků</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Složka</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Pořadí</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Dopředu</translation>
    </message>
    <message>
        <source>Backward</source>
        <translation>Pozpátku</translation>
    </message>
    <message>
        <source>There and back</source>
        <translation>Tam a zpět</translation>
    </message>
    <message>
        <source>F&amp;older:</source>
        <translation>S&amp;ložka:</translation>
    </message>
    <message>
        <source>Or&amp;der:</source>
        <translation>Po&amp;řadí:</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>Zvolte složku.</translation>
    </message>
    <message>
        <source>The folder is a file.</source>
        <translation>To není složka, ale soubor.</translation>
    </message>
    <message>
        <source>The folder that shall hold the new folder does not exist.</source>
        <translation>Složka, ve které má nová složka vzniknout, neexistuje.</translation>
    </message>
    <message>
        <source>The folder holds pictures already. Choose another one, so that they do not mix.</source>
        <translation>Ve složce už jsou obrázky. Zvolte jinou, aby se nepomíchaly.</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s) of %1 × %2 pixels. At %3 frames per second they last %4.</source>
        <translation>
            <numerusform>%n obrázek %1 × %2 pixelů. Při %3 snímcích za sekundu trvá %4.</numerusform>
            <numerusform>%n obrázky %1 × %2 pixelů. Při %3 snímcích za sekundu trvají %4.</numerusform>
            <numerusform>%n obrázků %1 × %2 pixelů. Při %3 snímcích za sekundu trvají %4.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>views::ExportPointCacheDialog</name>
    <message>
        <source>Export Point Cache</source>
        <translation>Export mezipaměti bodů</translation>
    </message>
    <message>
        <source>Output File</source>
        <translation>Výstupní soubor</translation>
    </message>
    <message>
        <source>Write the &amp;base mesh beside it</source>
        <translation>Zapsat vedle ní &amp;základní síť</translation>
    </message>
    <message>
        <source>PC2 Point Caches (%1)</source>
        <translation>Mezipaměti bodů PC2 (%1)</translation>
    </message>
    <message>
        <source>A point cache holds positions alone; the triangles are in its base mesh.</source>
        <translation>Mezipaměť bodů obsahuje jen polohy; trojúhelníky jsou v základní síti.</translation>
    </message>
    <message>
        <source>&amp;Output file:</source>
        <translation>&amp;Výstupní soubor:</translation>
    </message>
    <message>
        <source>%1 and its base mesh %2 will be written.</source>
        <translation>Zapíše se %1 a základní síť %2.</translation>
    </message>
    <message>
        <source>%1 will be written.</source>
        <translation>Zapíše se %1.</translation>
    </message>
</context>
<context>
    <name>views::ExportTerrainDialog</name>
    <message>
        <source>Mesh, OBJ</source>
        <translation>Síť, OBJ</translation>
    </message>
    <message>
        <source>Mesh, PLY</source>
        <translation>Síť, PLY</translation>
    </message>
    <message>
        <source>Mesh, STL</source>
        <translation>Síť, STL</translation>
    </message>
    <message>
        <source>Raster, GeoTIFF</source>
        <translation>Rastr, GeoTIFF</translation>
    </message>
    <message>
        <source>Raster, ESRI ASCII Grid</source>
        <translation>Rastr, ESRI ASCII Grid</translation>
    </message>
    <message>
        <source>Raster, PNG with 16 Bits</source>
        <translation>Rastr, PNG s 16 bity</translation>
    </message>
    <message>
        <source>Contours, GeoJSON</source>
        <translation>Vrstevnice, GeoJSON</translation>
    </message>
    <message>
        <source>Export Terrain</source>
        <translation>Export terénu</translation>
    </message>
    <message>
        <source>Output File</source>
        <translation>Výstupní soubor</translation>
    </message>
    <message>
        <source>In &amp;world coordinates</source>
        <translation>Ve &amp;světových souřadnicích</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Velikost buňky</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Interval</translation>
    </message>
    <message>
        <source>As the georeference says; else the terrain&apos;s south-western corner is the origin</source>
        <translation>Podle georeference; jinak je počátkem jihozápadní roh terénu</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>m of height</source>
        <translation>m výšky</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>&amp;Formát:</translation>
    </message>
    <message>
        <source>&amp;Output file:</source>
        <translation>&amp;Výstupní soubor:</translation>
    </message>
    <message>
        <source>&amp;Cell size:</source>
        <translation>Velikost &amp;buňky:</translation>
    </message>
    <message>
        <source>&amp;Interval:</source>
        <translation>&amp;Interval:</translation>
    </message>
    <message>
        <source>%1 vertices and %2 triangles will be written.</source>
        <translation>Bude zapsáno vrcholů: %1, trojúhelníků: %2.</translation>
    </message>
    <message>
        <source>%1 × %2 samples will be written.</source>
        <translation>Bude zapsáno %1 × %2 vzorků.</translation>
    </message>
</context>
<context>
    <name>views::ForceArrow</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
</context>
<context>
    <name>views::FoundSource</name>
    <message>
        <source>Folder of %1 frames</source>
        <translation>Složka snímků %1</translation>
    </message>
    <message>
        <source>%1 mesh</source>
        <translation>Síť %1</translation>
    </message>
    <message>
        <source>%1 point cache</source>
        <translation>Mezipaměť bodů %1</translation>
    </message>
    <message>
        <source>%1 scene</source>
        <translation>Scéna %1</translation>
    </message>
    <message>
        <source>Encoded animation</source>
        <translation>Zakódovaná animace</translation>
    </message>
    <message>
        <source>There is no such file or folder.</source>
        <translation>Takový soubor ani složka neexistuje.</translation>
    </message>
    <message>
        <source>You may not read it.</source>
        <translation>Nemáte právo ho číst.</translation>
    </message>
    <message>
        <source>The file has no ending that tells its format.</source>
        <translation>Soubor nemá příponu, podle které by se poznal jeho formát.</translation>
    </message>
    <message>
        <source>Files with the ending “.%1” cannot be read.</source>
        <translation>Soubory s příponou „.%1“ nelze číst.</translation>
    </message>
    <message>
        <source>Everything Readable (%1)</source>
        <translation>Vše, co lze číst (%1)</translation>
    </message>
    <message>
        <source>Point Caches (%1)</source>
        <translation>Mezipaměti bodů (%1)</translation>
    </message>
    <message>
        <source>Scenes (%1)</source>
        <translation>Scény (%1)</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>Sítě (%1)</translation>
    </message>
    <message>
        <source>Encoded Animations (%1)</source>
        <translation>Zakódované animace (%1)</translation>
    </message>
    <message>
        <source>All Files (%1)</source>
        <translation>Všechny soubory (%1)</translation>
    </message>
</context>
<context>
    <name>views::FramePicture</name>
    <message>
        <source>Preview</source>
        <translation>Náhled</translation>
    </message>
    <message>
        <source>Drag to turn, double-click to look from the start again</source>
        <translation>Tažením otočíte, dvojklikem se vrátíte k původnímu pohledu</translation>
    </message>
</context>
<context>
    <name>views::FramePreview</name>
    <message>
        <source>Frame of the preview</source>
        <translation>Snímek náhledu</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Snímek %1 z %2</translation>
    </message>
</context>
<context>
    <name>views::FrameRangeFields</name>
    <message>
        <source>First frame</source>
        <translation>První snímek</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Poslední snímek</translation>
    </message>
    <message>
        <source>F&amp;irst frame:</source>
        <translation>&amp;První snímek:</translation>
    </message>
    <message>
        <source>&amp;Last frame:</source>
        <translation>P&amp;oslední snímek:</translation>
    </message>
    <message>
        <source>The first frame must not come after the last.</source>
        <translation>První snímek nesmí být až za posledním.</translation>
    </message>
</context>
<context>
    <name>views::FrameRateDialog</name>
    <message>
        <source>Frame Rate</source>
        <translation>Snímková frekvence</translation>
    </message>
    <message>
        <source>&amp;Set Frame Rate</source>
        <translation>&amp;Nastavit frekvenci</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Snímková frekvence</translation>
    </message>
    <message>
        <source>frames per second</source>
        <translation>snímků za sekundu</translation>
    </message>
    <message>
        <source>&amp;Frame rate:</source>
        <translation>&amp;Snímková frekvence:</translation>
    </message>
    <message>
        <source>Duration: %1 → %2. The frames stay as they are.</source>
        <translation>Délka: %1 → %2. Snímky se nemění.</translation>
    </message>
</context>
<context>
    <name>views::HapticsDock</name>
    <message>
        <source>Haptics</source>
        <translation>Haptika</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Forces off, at once. Escape does the same anywhere in the program.</source>
        <translation>Okamžitě vypne síly. Escape udělá totéž kdekoli v programu.</translation>
    </message>
    <message>
        <source>Stop all forces</source>
        <translation>Vypnout všechny síly</translation>
    </message>
    <message>
        <source>&amp;Forces</source>
        <translation>Sí&amp;ly</translation>
    </message>
    <message>
        <source>Let the device push. Forces begin in the air and rise over two seconds.</source>
        <translation>Zařízení smí tlačit. Síly začínají ve vzduchu a rostou dvě sekundy.</translation>
    </message>
    <message>
        <source>State of the forces</source>
        <translation>Stav sil</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Zařízení</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>Hmat</translation>
    </message>
    <message>
        <source>As the Ground Is</source>
        <translation>Podle terénu</translation>
    </message>
    <message>
        <source>What the ground feels like; what it is does not change.</source>
        <translation>Jaký je terén na dotek; čím je, se nezmění.</translation>
    </message>
    <message>
        <source>Material:</source>
        <translation>Materiál:</translation>
    </message>
    <message>
        <source>Force law:</source>
        <translation>Zákon síly:</translation>
    </message>
    <message>
        <source>Gain:</source>
        <translation>Zesílení:</translation>
    </message>
    <message>
        <source>The force of the ground, times this</source>
        <translation>Kolikrát se zesílí síla terénu</translation>
    </message>
    <message>
        <source>At most:</source>
        <translation>Nejvýše:</translation>
    </message>
    <message>
        <source>No force is above this, nor above what the device is made for</source>
        <translation>Žádná síla není větší, ani větší, než pro jakou je zařízení určeno</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Nyní</translation>
    </message>
    <message>
        <source>Position:</source>
        <translation>Poloha:</translation>
    </message>
    <message>
        <source>Of the hand, in millimetres: right, away, up</source>
        <translation>Ruky, v milimetrech: vpravo, od sebe, nahoru</translation>
    </message>
    <message>
        <source>Force:</source>
        <translation>Síla:</translation>
    </message>
    <message>
        <source>On the hand, in newtons: right, away, up</source>
        <translation>Na ruku, v newtonech: vpravo, od sebe, nahoru</translation>
    </message>
    <message>
        <source>Rate:</source>
        <translation>Frekvence:</translation>
    </message>
    <message>
        <source>Steps of the servo in a second, of a thousand that are due</source>
        <translation>Kroky smyčky za sekundu, z tisíce, které mají přijít</translation>
    </message>
    <message>
        <source>Lateness:</source>
        <translation>Zpoždění:</translation>
    </message>
    <message>
        <source>99 of 100 steps began no later than this</source>
        <translation>99 ze 100 kroků nezačalo později</translation>
    </message>
    <message>
        <source>right</source>
        <translation>vpravo</translation>
    </message>
    <message>
        <source>away</source>
        <translation>od sebe</translation>
    </message>
    <message>
        <source>up</source>
        <translation>nahoru</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Síla (N)</translation>
    </message>
    <message>
        <source>Position (mm)</source>
        <translation>Poloha (mm)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Žádné</translation>
    </message>
    <message>
        <source>%1 (unplugged)</source>
        <translation>%1 (odpojeno)</translation>
    </message>
    <message>
        <source>Choose the simulated device to feel the ground with the mouse, or plug one in.</source>
        <translation>Vyberte simulované zařízení a ohmatejte terén myší, nebo nějaké připojte.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 Hz, %2 skipped</source>
        <translation>%1 Hz, vynecháno %2</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
</context>
<context>
    <name>views::HapticsTexts</name>
    <message>
        <source>Forces are off.</source>
        <translation>Síly jsou vypnuté.</translation>
    </message>
    <message>
        <source>No force: the window was busy for too long.</source>
        <translation>Bez síly: okno bylo příliš dlouho zaneprázdněné.</translation>
    </message>
    <message>
        <source>No force: the machine was too late.</source>
        <translation>Bez síly: počítač nestíhal.</translation>
    </message>
    <message>
        <source>No force: the device says nothing.</source>
        <translation>Bez síly: zařízení mlčí.</translation>
    </message>
    <message>
        <source>No force: the device is unplugged.</source>
        <translation>Bez síly: zařízení je odpojené.</translation>
    </message>
    <message>
        <source>No force: a number was not one. Switch forces off and on.</source>
        <translation>Bez síly: některé číslo nebylo číslem. Vypněte síly a znovu je zapněte.</translation>
    </message>
    <message>
        <source>Granular</source>
        <translation>Sypký materiál</translation>
    </message>
    <message>
        <source>2009, Averaged</source>
        <translation>2009, průměr</translation>
    </message>
    <message>
        <source>2009, Along the Motion</source>
        <translation>2009, ve směru pohybu</translation>
    </message>
    <message>
        <source>Resists more with depth, gives way, and holds the tool when it is wet.</source>
        <translation>S hloubkou klade větší odpor, ustupuje, a vlhký drží nástroj.</translation>
    </message>
    <message>
        <source>An older model, to compare: a spring above the ground, and the mean of all directions.</source>
        <translation>Starší model pro srovnání: pružina nad terénem a průměr všech směrů.</translation>
    </message>
    <message>
        <source>An older model, to compare: it trembles when the tool hardly moves.</source>
        <translation>Starší model pro srovnání: třese se, když se nástroj téměř nehýbe.</translation>
    </message>
    <message>
        <source>Simulated Device</source>
        <translation>Simulované zařízení</translation>
    </message>
    <message>
        <source>%1 (no permission)</source>
        <translation>%1 (bez oprávnění)</translation>
    </message>
    <message>
        <source>You have no permission to use this device. Copy %1, which comes with Sandreel, to /etc/udev/rules.d, and plug the device in again.</source>
        <translation>K tomuto zařízení nemáte oprávnění. Zkopírujte soubor %1, který se dodává se Sandreelem, do /etc/udev/rules.d a zařízení znovu připojte.</translation>
    </message>
    <message>
        <source>The mouse moves the tool, the wheel or Page Up and Page Down lift it and press it in, the left button draws. Ctrl and the wheel zoom.</source>
        <translation>Myš pohybuje nástrojem, kolečko nebo Page Up a Page Down ho zvedá a zatlačuje, levé tlačítko kreslí. Ctrl s kolečkem přibližuje.</translation>
    </message>
    <message>
        <source>It moves the tool while its cap is pushed; a button draws. It has no force.</source>
        <translation>Pohybuje nástrojem, dokud tlačíte na jeho hlavici; tlačítko kreslí. Nemá sílu.</translation>
    </message>
    <message>
        <source>Experimental: nobody has tried every stick. Hold it loosely.</source>
        <translation>Experimentální: všechny páky nikdo nevyzkoušel. Držte ji volně.</translation>
    </message>
    <message>
        <source>No device.</source>
        <translation>Žádné zařízení.</translation>
    </message>
    <message>
        <source>The device is unplugged. Plug it in to go on.</source>
        <translation>Zařízení je odpojené. Připojte ho, chcete-li pokračovat.</translation>
    </message>
    <message>
        <source>The device moves the tool.</source>
        <translation>Zařízení pohybuje nástrojem.</translation>
    </message>
    <message>
        <source>Lift the tool: forces begin in the air.</source>
        <translation>Zvedněte nástroj: síly začínají ve vzduchu.</translation>
    </message>
    <message>
        <source>Forces are rising.</source>
        <translation>Síly rostou.</translation>
    </message>
    <message>
        <source>Forces are on.</source>
        <translation>Síly jsou zapnuté.</translation>
    </message>
    <message>
        <source>Forces fade.</source>
        <translation>Síly slábnou.</translation>
    </message>
</context>
<context>
    <name>views::HistoryDock</name>
    <message>
        <source>As Opened</source>
        <translation>Po otevření</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historie</translation>
    </message>
    <message>
        <source>In memory: %1</source>
        <translation>V paměti: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n older steps were dropped to stay within the limit.</source>
        <translation>
            <numerusform>%n starší krok byl zahozen kvůli mezi.</numerusform>
            <numerusform>%n starší kroky byly zahozeny kvůli mezi.</numerusform>
            <numerusform>%n starších kroků bylo zahozeno kvůli mezi.</numerusform>
        </translation>
    </message>
    <message>
        <source>Oldest Step Kept</source>
        <translation>Nejstarší uchovaný krok</translation>
    </message>
    <message>
        <source>Steps of the document</source>
        <translation>Kroky dokumentu</translation>
    </message>
    <message>
        <source>Limit of the history</source>
        <translation>Mez historie</translation>
    </message>
    <message>
        <source>&amp;Limit:</source>
        <translation>&amp;Mez:</translation>
    </message>
</context>
<context>
    <name>views::ImportTerrainDialog</name>
    <message>
        <source>8 bits</source>
        <translation>8 bitů</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 bitů</translation>
    </message>
    <message>
        <source>16 bits with sign</source>
        <translation>16 bitů se znaménkem</translation>
    </message>
    <message>
        <source>32 bits</source>
        <translation>32 bitů</translation>
    </message>
    <message>
        <source>32 bits, floating point</source>
        <translation>32 bitů, plovoucí čárka</translation>
    </message>
    <message>
        <source>64 bits, floating point</source>
        <translation>64 bitů, plovoucí čárka</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Zdroj</translation>
    </message>
    <message>
        <source>Import Terrain</source>
        <translation>Import terénu</translation>
    </message>
    <message>
        <source>Terrains of Other Programs (%1)</source>
        <translation>Terény jiných programů (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Všechny soubory (*)</translation>
    </message>
    <message>
        <source>&amp;Source:</source>
        <translation>&amp;Zdroj:</translation>
    </message>
    <message>
        <source>Largest &amp;error:</source>
        <translation>Největší &amp;chyba:</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>Největší chyba</translation>
    </message>
    <message>
        <source>m of height; fewer triangles where it is flat</source>
        <translation>m výšky; v rovině méně trojúhelníků</translation>
    </message>
    <message>
        <source>&amp;Cell size:</source>
        <translation>Velikost &amp;buňky:</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Velikost buňky</translation>
    </message>
    <message>
        <source>m, if the file does not say</source>
        <translation>m, pokud to soubor neuvádí</translation>
    </message>
    <message>
        <source>&amp;Height scale:</source>
        <translation>&amp;Měřítko výšky:</translation>
    </message>
    <message>
        <source>Height scale</source>
        <translation>Měřítko výšky</translation>
    </message>
    <message>
        <source>m for 1 in the file</source>
        <translation>m na 1 v souboru</translation>
    </message>
    <message>
        <source>C&amp;olumns:</source>
        <translation>S&amp;loupce:</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Sloupce</translation>
    </message>
    <message>
        <source>&amp;Rows:</source>
        <translation>Řá&amp;dky:</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Řádky</translation>
    </message>
    <message>
        <source>&amp;Numbers:</source>
        <translation>Čí&amp;sla:</translation>
    </message>
    <message>
        <source>Little end first</source>
        <translation>Od nejnižšího bajtu</translation>
    </message>
    <message>
        <source>Big end first</source>
        <translation>Od nejvyššího bajtu</translation>
    </message>
    <message>
        <source>&amp;Bytes:</source>
        <translation>Ba&amp;jty:</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>&amp;Upwards is:</source>
        <translation>&amp;Vzhůru je:</translation>
    </message>
    <message>
        <source>EPSG:5514, or nothing; if the file does not say</source>
        <translation>EPSG:5514, nebo nic; pokud to soubor neuvádí</translation>
    </message>
    <message>
        <source>Coordinate s&amp;ystem:</source>
        <translation>Souřadnicový s&amp;ystém:</translation>
    </message>
    <message>
        <source>Layers:</source>
        <translation>Vrstvy:</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importovat</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
    <message>
        <source>Choose a file: a raster of heights, points, or a mesh.</source>
        <translation>Vyberte soubor: výškový rastr, body, nebo síť.</translation>
    </message>
    <message>
        <source>There is no such file.</source>
        <translation>Takový soubor neexistuje.</translation>
    </message>
    <message>
        <source>Files of this kind cannot be imported.</source>
        <translation>Soubory tohoto druhu nelze importovat.</translation>
    </message>
</context>
<context>
    <name>views::InspectorDock</name>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>Lists of the inspector</source>
        <translation>Seznamy inspektoru</translation>
    </message>
    <message>
        <source>&amp;Copy Rows</source>
        <translation>&amp;Kopírovat řádky</translation>
    </message>
    <message>
        <source>Copy the selected rows, or all, as a table</source>
        <translation>Kopírovat vybrané řádky, nebo všechny, jako tabulku</translation>
    </message>
    <message>
        <source>&amp;Save Report…</source>
        <translation>&amp;Uložit zprávu…</translation>
    </message>
    <message>
        <source>Write everything that was found as CSV or JSON</source>
        <translation>Zapsat vše, co bylo zjištěno, jako CSV nebo JSON</translation>
    </message>
    <message>
        <source>Parts that hang together by edges. Selecting one makes the others step back.</source>
        <translation>Části, které drží pohromadě hranami. Po výběru jedné ostatní ustoupí do pozadí.</translation>
    </message>
    <message>
        <source>Missing faces: loops of edges that have a face on one side only.</source>
        <translation>Chybějící stěny: smyčky hran, které mají stěnu jen na jedné straně.</translation>
    </message>
    <message>
        <source>Nothing is missing here: a handle is a bridge over a tunnel, as in a ring. One loop goes round it, the other through its tunnel.</source>
        <translation>Tady nic nechybí: ucho je most přes tunel, jako u prstenu. Jedna smyčka vede kolem něj, druhá jeho tunelem.</translation>
    </message>
    <message>
        <source>What a program that expects a clean surface may stumble over. Nothing is repaired unasked.</source>
        <translation>Co může zaskočit program, který očekává čistý povrch. Nic se neopravuje bez požádání.</translation>
    </message>
    <message>
        <source>Components of the mesh</source>
        <translation>Komponenty sítě</translation>
    </message>
    <message>
        <source>Holes of the mesh</source>
        <translation>Díry sítě</translation>
    </message>
    <message>
        <source>Handles of the mesh</source>
        <translation>Ucha sítě</translation>
    </message>
    <message>
        <source>Problems of the mesh</source>
        <translation>Problémy sítě</translation>
    </message>
    <message>
        <source>Components (%1)</source>
        <translation>Komponenty (%1)</translation>
    </message>
    <message>
        <source>Holes (%1)</source>
        <translation>Díry (%1)</translation>
    </message>
    <message>
        <source>Handles (%1)</source>
        <translation>Ucha (%1)</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>Problémy (%1)</translation>
    </message>
</context>
<context>
    <name>views::JobPanel</name>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Průběh</translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation>zbývá asi %1</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Zastavuje se…</translation>
    </message>
    <message>
        <source>almost done</source>
        <translation>téměř hotovo</translation>
    </message>
</context>
<context>
    <name>views::LatenessPlot</name>
    <message>
        <source>Lateness of the steps</source>
        <translation>Zpoždění kroků</translation>
    </message>
    <message>
        <source>99 %</source>
        <translation>99 %</translation>
    </message>
</context>
<context>
    <name>views::LayersField</name>
    <message>
        <source>Dry Sand</source>
        <translation>Suchý písek</translation>
    </message>
    <message>
        <source>Moist Sand</source>
        <translation>Vlhký písek</translation>
    </message>
    <message>
        <source>Mud</source>
        <translation>Bláto</translation>
    </message>
    <message>
        <source>Snow</source>
        <translation>Sníh</translation>
    </message>
    <message>
        <source>Gravel</source>
        <translation>Štěrk</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Vlastní</translation>
    </message>
    <message>
        <source>&amp;Add Layer</source>
        <translation>Přid&amp;at vrstvu</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Tloušťka</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Material of layer %1 from above</source>
        <translation>Materiál %1. vrstvy shora</translation>
    </message>
    <message>
        <source>Thickness of layer %1 from above</source>
        <translation>Tloušťka %1. vrstvy shora</translation>
    </message>
    <message>
        <source>Remove layer %1 from above</source>
        <translation>Odebrat %1. vrstvu shora</translation>
    </message>
    <message>
        <source>Remove this layer</source>
        <translation>Odebrat tuto vrstvu</translation>
    </message>
</context>
<context>
    <name>views::Legend</name>
    <message>
        <source>metres</source>
        <translation>v metrech</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Sklon</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>ve stupních</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>Vlhkost</translation>
    </message>
    <message>
        <source>% of saturation</source>
        <translation>% nasycení</translation>
    </message>
    <message>
        <source>top layer</source>
        <translation>horní vrstva</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Tloušťka</translation>
    </message>
    <message>
        <source>all layers</source>
        <translation>všechny vrstvy</translation>
    </message>
    <message>
        <source>Cut and fill</source>
        <translation>Výkop a násyp</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>Maska</translation>
    </message>
    <message>
        <source>% protected</source>
        <translation>% ochrany</translation>
    </message>
</context>
<context>
    <name>views::LogDock</name>
    <message>
        <source>Log</source>
        <translation>Záznam</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopírovat</translation>
    </message>
    <message>
        <source>Copy the selected messages, or all</source>
        <translation>Kopírovat vybrané zprávy, nebo všechny</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vymazat</translation>
    </message>
    <message>
        <source>Clear the log</source>
        <translation>Vymazat záznam</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Zprávy</translation>
    </message>
</context>
<context>
    <name>views::LogModel</name>
    <message>
        <source>Time</source>
        <translation>Čas</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Druh</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Zpráva</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Informace</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Varování</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Chyba</translation>
    </message>
</context>
<context>
    <name>views::MaterialDock</name>
    <message>
        <source>Materials</source>
        <translation>Materiály</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Vrstvy</translation>
    </message>
    <message>
        <source>Layers, the top one first</source>
        <translation>Vrstvy od nejvyšší</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiál</translation>
    </message>
    <message>
        <source>Mean Thickness</source>
        <translation>Průměrná tloušťka</translation>
    </message>
    <message>
        <source>Material:</source>
        <translation>Materiál:</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Tloušťka</translation>
    </message>
    <message>
        <source>Thickness:</source>
        <translation>Tloušťka:</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>Vlhkost</translation>
    </message>
    <message>
        <source>Humidity:</source>
        <translation>Vlhkost:</translation>
    </message>
    <message>
        <source>&amp;Add on Top</source>
        <translation>&amp;Přidat nahoru</translation>
    </message>
    <message>
        <source>&amp;Fill Layer</source>
        <translation>&amp;Vyplnit vrstvu</translation>
    </message>
    <message>
        <source>Give the layer this thickness and humidity everywhere; the bedrock gives way</source>
        <translation>Dát vrstvě všude tuto tloušťku a vlhkost; podloží ustoupí</translation>
    </message>
    <message>
        <source>&amp;Remove Layer</source>
        <translation>&amp;Odebrat vrstvu</translation>
    </message>
    <message>
        <source>What it held becomes bedrock</source>
        <translation>Její obsah se stane podložím</translation>
    </message>
    <message>
        <source>Preset:</source>
        <translation>Předvolba:</translation>
    </message>
    <message>
        <source>Density:</source>
        <translation>Hustota:</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>Poured humidity:</source>
        <translation>Vlhkost při sypání:</translation>
    </message>
    <message>
        <source>Compressibility:</source>
        <translation>Stlačitelnost:</translation>
    </message>
    <message>
        <source>A&amp;dd Material</source>
        <translation>Přidat &amp;materiál</translation>
    </message>
    <message>
        <source>R&amp;emove Material</source>
        <translation>Odebrat m&amp;ateriál</translation>
    </message>
    <message>
        <source>Critical angle</source>
        <translation>Kritický úhel</translation>
    </message>
    <message>
        <source>Angle at humidity %1:</source>
        <translation>Úhel při vlhkosti %1:</translation>
    </message>
</context>
<context>
    <name>views::MaterialTitles</name>
    <message>
        <source>Dry Sand</source>
        <translation>Suchý písek</translation>
    </message>
    <message>
        <source>Moist Sand</source>
        <translation>Vlhký písek</translation>
    </message>
    <message>
        <source>Mud</source>
        <translation>Bláto</translation>
    </message>
    <message>
        <source>Snow</source>
        <translation>Sníh</translation>
    </message>
    <message>
        <source>Gravel</source>
        <translation>Štěrk</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Vlastní</translation>
    </message>
</context>
<context>
    <name>views::MeshView</name>
    <message>
        <source>Mesh</source>
        <translation>Síť</translation>
    </message>
    <message>
        <source>The mesh in 3D. Arrow keys turn it, plus and minus zoom, F shows all of it.</source>
        <translation>Síť ve 3D. Šipky ji otáčejí, plus a minus přibližují a oddalují, F ji ukáže celou.</translation>
    </message>
    <message>
        <source>Colour:</source>
        <translation>Barva:</translation>
    </message>
    <message>
        <source>What colours tell</source>
        <translation>Co říkají barvy</translation>
    </message>
    <message>
        <source>Pick:</source>
        <translation>Výběr:</translation>
    </message>
    <message>
        <source>What a click picks</source>
        <translation>Co vybere kliknutí</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Stěny</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Hrany</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vrcholy</translation>
    </message>
    <message>
        <source>Draw the edges of the faces</source>
        <translation>Kreslit hrany stěn</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Hladce</translation>
    </message>
    <message>
        <source>Draw smooth surfaces instead of flat faces</source>
        <translation>Kreslit hladký povrch místo plochých stěn</translation>
    </message>
    <message>
        <source>Normals</source>
        <translation>Normály</translation>
    </message>
    <message>
        <source>Draw the normal of each vertex</source>
        <translation>Kreslit normálu každého vrcholu</translation>
    </message>
    <message>
        <source>See Through</source>
        <translation>Průhledně</translation>
    </message>
    <message>
        <source>Let what lies behind the surface show</source>
        <translation>Ukázat i to, co je za povrchem</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Řez</translation>
    </message>
    <message>
        <source>Cut a part of the mesh away</source>
        <translation>Odříznout část sítě</translation>
    </message>
    <message>
        <source>Loops</source>
        <translation>Smyčky</translation>
    </message>
    <message>
        <source>Draw the borders of holes and the loops of handles as tubes</source>
        <translation>Kreslit okraje děr a smyčky uch jako trubice</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problémy</translation>
    </message>
    <message>
        <source>Mark what is wrong with the mesh</source>
        <translation>Vyznačit, co je na síti špatně</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Celé</translation>
    </message>
    <message>
        <source>Move the camera so that all is seen</source>
        <translation>Posunout kameru tak, aby bylo vidět vše</translation>
    </message>
    <message>
        <source>Other Side</source>
        <translation>Druhá strana</translation>
    </message>
    <message>
        <source>Cut the other side away</source>
        <translation>Odříznout druhou stranu</translation>
    </message>
    <message>
        <source>Cut across:</source>
        <translation>Řez kolmo na:</translation>
    </message>
    <message>
        <source>Axis across which the mesh is cut</source>
        <translation>Osa, kolmo na kterou je síť říznutá</translation>
    </message>
    <message>
        <source>Where the mesh is cut</source>
        <translation>Kde je síť říznutá</translation>
    </message>
    <message>
        <source>What was picked</source>
        <translation>Co bylo vybráno</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Žádná</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenty</translation>
    </message>
    <message>
        <source>Preparing the picture…</source>
        <translation>Připravuje se obraz…</translation>
    </message>
    <message>
        <source>The mesh is empty.</source>
        <translation>Síť je prázdná.</translation>
    </message>
    <message>
        <source>Analysing…</source>
        <translation>Zkoumá se…</translation>
    </message>
    <message>
        <source>Looking for handles…</source>
        <translation>Hledají se ucha…</translation>
    </message>
    <message>
        <source>Click a face, an edge or a vertex to read about it.</source>
        <translation>Klikněte na stěnu, hranu nebo vrchol a přečtěte si o nich.</translation>
    </message>
</context>
<context>
    <name>views::MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Zavřít</translation>
    </message>
    <message>
        <source>Dismiss Message</source>
        <translation>Zavřít zprávu</translation>
    </message>
</context>
<context>
    <name>views::NewTerrainDialog</name>
    <message>
        <source>Dunes</source>
        <translation>Duny</translation>
    </message>
    <message>
        <source>Hills</source>
        <translation>Kopce</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Rovina</translation>
    </message>
    <message>
        <source>New Terrain</source>
        <translation>Nový terén</translation>
    </message>
    <message>
        <source>&amp;Shape:</source>
        <translation>&amp;Tvar:</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>&amp;Width:</source>
        <translation>Šíř&amp;ka:</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Šířka</translation>
    </message>
    <message>
        <source>&amp;Depth:</source>
        <translation>&amp;Hloubka:</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Hloubka</translation>
    </message>
    <message>
        <source>&amp;Resolution:</source>
        <translation>&amp;Rozlišení:</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Rozlišení</translation>
    </message>
    <message>
        <source>m between vertices</source>
        <translation>m mezi vrcholy</translation>
    </message>
    <message>
        <source>&amp;Height:</source>
        <translation>Vý&amp;ška:</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Si&amp;ze:</source>
        <translation>&amp;Velikost:</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Velikost</translation>
    </message>
    <message>
        <source>m from crest to crest</source>
        <translation>m od hřebene k hřebeni</translation>
    </message>
    <message>
        <source>S&amp;eed:</source>
        <translation>Semín&amp;ko:</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semínko</translation>
    </message>
    <message>
        <source>another number, another terrain</source>
        <translation>jiné číslo, jiný terén</translation>
    </message>
    <message>
        <source>Layers:</source>
        <translation>Vrstvy:</translation>
    </message>
    <message>
        <source>&amp;Create</source>
        <translation>V&amp;ytvořit</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
    <message>
        <source>%1 vertices are too many; at most %2 can be made. Choose a larger distance between them.</source>
        <translation>%1 vrcholů je příliš mnoho; vytvořit jich lze nejvýše %2. Zvolte mezi nimi větší vzdálenost.</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>vrcholů: %1</translation>
    </message>
</context>
<context>
    <name>views::NoGlTerrainView</name>
    <message>
        <source>Terrain</source>
        <translation>Terén</translation>
    </message>
    <message>
        <source>A map from above: the 3D view needs OpenGL 3.3.</source>
        <translation>Mapa shora: pohled ve 3D vyžaduje OpenGL 3.3.</translation>
    </message>
    <message>
        <source>A map of the terrain from above. The 3D view needs OpenGL 3.3. While you sculpt, arrow keys move the tool and Space presses and lifts it.</source>
        <translation>Mapa terénu shora. Prostorový pohled potřebuje OpenGL 3.3. Při tvarování šipky posouvají nástroj a mezerník ho přitlačí a zvedne.</translation>
    </message>
</context>
<context>
    <name>views::NoGlView</name>
    <message>
        <source>No OpenGL was found on this computer.</source>
        <translation>Na tomto počítači nebylo nalezeno žádné OpenGL.</translation>
    </message>
    <message>
        <source>This computer offers OpenGL %1 (%2).</source>
        <translation>Tento počítač nabízí OpenGL %1 (%2).</translation>
    </message>
    <message>
        <source>The 3D view needs OpenGL 3.3. Installing the newest driver of the graphics card, or Mesa&apos;s software renderer, helps. Until then the processor draws the animation, slowly; everything else works.</source>
        <translation>Prostorové zobrazení potřebuje OpenGL 3.3. Pomůže nainstalovat nejnovější ovladač grafické karty nebo softwarové vykreslování Mesa. Do té doby kreslí animaci pomalu procesor; vše ostatní funguje.</translation>
    </message>
</context>
<context>
    <name>views::NormalisationChoice</name>
    <message>
        <source>Normalise</source>
        <translation>Normalizace</translation>
    </message>
    <message>
        <source>No, keep coordinates</source>
        <translation>Ne, ponechat souřadnice</translation>
    </message>
    <message>
        <source>First frame fills the cube from −1 to 1</source>
        <translation>První snímek vyplní krychli od −1 do 1</translation>
    </message>
    <message>
        <source>All frames fill the cube from −1 to 1</source>
        <translation>Všechny snímky vyplní krychli od −1 do 1</translation>
    </message>
    <message>
        <source>not normalised</source>
        <translation>bez normalizace</translation>
    </message>
    <message>
        <source>normalised by the first frame</source>
        <translation>normalizováno podle prvního snímku</translation>
    </message>
    <message>
        <source>normalised by all frames</source>
        <translation>normalizováno podle všech snímků</translation>
    </message>
</context>
<context>
    <name>views::NormaliseDialog</name>
    <message>
        <source>Normalise Animation</source>
        <translation>Normalizovat animaci</translation>
    </message>
    <message>
        <source>&amp;Normalise</source>
        <translation>&amp;Normalizovat</translation>
    </message>
    <message>
        <source>&amp;Mode:</source>
        <translation>&amp;Způsob:</translation>
    </message>
    <message>
        <source>Looking at every frame…</source>
        <translation>Procházejí se všechny snímky…</translation>
    </message>
    <message>
        <source>The animation goes back to the coordinates of its file.</source>
        <translation>Animace se vrátí k souřadnicím ze souboru.</translation>
    </message>
    <message>
        <source>The animation is moved and scaled, by one factor for all axes. Doing it again changes nothing.</source>
        <translation>Animace se posune a změní se její měřítko, pro všechny osy stejně. Opakování už nic nezmění.</translation>
    </message>
</context>
<context>
    <name>views::NumberField</name>
    <message>
        <source>%1: enter %2.</source>
        <translation>%1: zadejte %2.</translation>
    </message>
    <message>
        <source>Allowed: %1</source>
        <translation>Povoleno: %1</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>celé číslo od %1 do %2</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>číslo od %1 do %2</translation>
    </message>
</context>
<context>
    <name>views::PartTable</name>
    <message>
        <source>No.</source>
        <translation>Č.</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vrcholy</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Hrany</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Stěny</translation>
    </message>
    <message>
        <source>Euler</source>
        <translation>Euler</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Rod</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Díry</translation>
    </message>
    <message>
        <source>Orientable</source>
        <translation>Orientovatelná</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Plocha</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Objem</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Komponenta</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Délka</translation>
    </message>
    <message>
        <source>Short Loop</source>
        <translation>Krátká smyčka</translation>
    </message>
    <message>
        <source>Long Loop</source>
        <translation>Dlouhá smyčka</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problém</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Kde</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ano</translation>
    </message>
    <message>
        <source>no</source>
        <translation>ne</translation>
    </message>
    <message>
        <source>The number of handles; of a one-sided component that of its cross-caps</source>
        <translation>Počet uch; u jednostranné komponenty počet křížových čepiček</translation>
    </message>
    <message>
        <source>Vertices − edges + faces</source>
        <translation>Vrcholy − hrany + stěny</translation>
    </message>
    <message>
        <source>Of a flat lid that would close the hole</source>
        <translation>Plochého víka, které by díru uzavřelo</translation>
    </message>
</context>
<context>
    <name>views::PathField</name>
    <message>
        <source>Name the output file.</source>
        <translation>Zadejte výstupní soubor.</translation>
    </message>
    <message>
        <source>The output file is a folder.</source>
        <translation>Výstupní soubor je složka.</translation>
    </message>
    <message>
        <source>The folder of the output file does not exist.</source>
        <translation>Složka výstupního souboru neexistuje.</translation>
    </message>
    <message>
        <source>You may not write to the folder of the output file.</source>
        <translation>Do složky výstupního souboru nemáte právo zapisovat.</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Procházet…</translation>
    </message>
    <message>
        <source>Browse Folder…</source>
        <translation>Vybrat složku…</translation>
    </message>
    <message>
        <source>Browse File…</source>
        <translation>Vybrat soubor…</translation>
    </message>
</context>
<context>
    <name>views::PictureSizeFields</name>
    <message>
        <source>Width</source>
        <translation>Šířka</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Výška</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Velikost</translation>
    </message>
    <message>
        <source>As in the window (%1 × %2)</source>
        <translation>Jako v okně (%1 × %2)</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Jiná</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pixelů</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Měřítko</translation>
    </message>
    <message>
        <source>Si&amp;ze:</source>
        <translation>&amp;Velikost:</translation>
    </message>
    <message>
        <source>&amp;Width:</source>
        <translation>Šíř&amp;ka:</translation>
    </message>
    <message>
        <source>&amp;Height:</source>
        <translation>Vý&amp;ška:</translation>
    </message>
    <message>
        <source>S&amp;cale:</source>
        <translation>&amp;Měřítko:</translation>
    </message>
    <message>
        <source>%1 × %2 pixels are too many; this computer draws at most %3 × %4.</source>
        <translation>%1 × %2 pixelů je příliš mnoho; tento počítač vykreslí nejvýše %3 × %4.</translation>
    </message>
</context>
<context>
    <name>views::PrepareDialog</name>
    <message>
        <source>Prepare Animation</source>
        <translation>Připravit animaci</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Výsledky</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Zdroj</translation>
    </message>
    <message>
        <source>Folder of frames, point cache or scene: type, drop or browse</source>
        <translation>Složka snímků, mezipaměť bodů nebo scéna: napište, přetáhněte nebo vyberte</translation>
    </message>
    <message>
        <source>Base Mesh</source>
        <translation>Základní síť</translation>
    </message>
    <message>
        <source>The mesh of the same name beside the point cache</source>
        <translation>Síť stejného jména vedle mezipaměti bodů</translation>
    </message>
    <message>
        <source>Bake at</source>
        <translation>Zapéct při</translation>
    </message>
    <message>
        <source>frames per second</source>
        <translation>snímků za sekundu</translation>
    </message>
    <message>
        <source>Animation of the scene</source>
        <translation>Animace scény</translation>
    </message>
    <message>
        <source>For scenes that hold several animations</source>
        <translation>Pro scény s více animacemi</translation>
    </message>
    <message>
        <source>&amp;Source:</source>
        <translation>&amp;Zdroj:</translation>
    </message>
    <message>
        <source>Base &amp;mesh:</source>
        <translation>Základní &amp;síť:</translation>
    </message>
    <message>
        <source>Ba&amp;ke at:</source>
        <translation>&amp;Zapéct při:</translation>
    </message>
    <message>
        <source>Anima&amp;tion:</source>
        <translation>Ani&amp;mace:</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Nastavení</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Jméno</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Snímková frekvence</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Jméno:</translation>
    </message>
    <message>
        <source>Frame &amp;rate:</source>
        <translation>Snímková &amp;frekvence:</translation>
    </message>
    <message>
        <source>Normalis&amp;e:</source>
        <translation>&amp;Normalizace:</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Nalezeno</translation>
    </message>
    <message>
        <source>Format:</source>
        <translation>Formát:</translation>
    </message>
    <message>
        <source>Frames:</source>
        <translation>Snímky:</translation>
    </message>
    <message>
        <source>Vertices:</source>
        <translation>Vrcholy:</translation>
    </message>
    <message>
        <source>Triangles:</source>
        <translation>Trojúhelníky:</translation>
    </message>
    <message>
        <source>Box:</source>
        <translation>Rozměry:</translation>
    </message>
    <message>
        <source>Raw size:</source>
        <translation>Surová velikost:</translation>
    </message>
    <message>
        <source>The positions alone, as 32-bit numbers</source>
        <translation>Jen polohy jako 32bitová čísla</translation>
    </message>
    <message>
        <source>Output File</source>
        <translation>Výstupní soubor</translation>
    </message>
    <message>
        <source>Encoded Animations (%1)</source>
        <translation>Zakódované animace (%1)</translation>
    </message>
    <message>
        <source>&amp;Output file:</source>
        <translation>&amp;Výstupní soubor:</translation>
    </message>
    <message>
        <source>Encoding…</source>
        <translation>Kóduje se…</translation>
    </message>
    <message>
        <source>En&amp;code</source>
        <translation>Zakó&amp;dovat</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zavřít</translation>
    </message>
    <message>
        <source>The first frame is shown here.</source>
        <translation>Zde se ukáže první snímek.</translation>
    </message>
    <message>
        <source>Reading… %1 %</source>
        <translation>Čte se… %1 %</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>All frames together, from %1 to %2</source>
        <translation>Všechny snímky dohromady, od %1 do %2</translation>
    </message>
    <message>
        <source>one step: %1 % of the longest side</source>
        <translation>jeden krok: %1 % nejdelší strany</translation>
    </message>
    <message>
        <source>steps per unit of length</source>
        <translation>kroků na jednotku délky</translation>
    </message>
    <message>
        <source>Choose a source.</source>
        <translation>Zvolte zdroj.</translation>
    </message>
    <message>
        <source>The source is being read.</source>
        <translation>Zdroj se čte.</translation>
    </message>
    <message>
        <source>The source cannot be read.</source>
        <translation>Zdroj nelze přečíst.</translation>
    </message>
    <message>
        <source>The output file exists. You will be asked before it is replaced.</source>
        <translation>Výstupní soubor existuje. Před nahrazením se program zeptá.</translation>
    </message>
    <message>
        <source>“%1” exists. Replace it?</source>
        <translation>Soubor „%1“ už existuje. Nahradit ho?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Nahradit</translation>
    </message>
    <message>
        <source>Cancelled. Nothing was written.</source>
        <translation>Zrušeno. Nic nebylo zapsáno.</translation>
    </message>
    <message>
        <source>The animation is still being encoded.</source>
        <translation>Animace se ještě kóduje.</translation>
    </message>
    <message>
        <source>Stop Encoding</source>
        <translation>Zastavit kódování</translation>
    </message>
    <message>
        <source>Keep Encoding</source>
        <translation>Pokračovat v kódování</translation>
    </message>
    <message>
        <source>Size and Error</source>
        <translation>Velikost a chyba</translation>
    </message>
</context>
<context>
    <name>views::ProfileDock</name>
    <message>
        <source>Cross-Section</source>
        <translation>Řez</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Vést</translation>
    </message>
    <message>
        <source>Pick on the Ground</source>
        <translation>Vést po povrchu</translation>
    </message>
    <message>
        <source>Copy &amp;Table</source>
        <translation>Kopírovat &amp;tabulku</translation>
    </message>
    <message>
        <source>Put the cross-section on the clipboard as comma-separated values</source>
        <translation>Dát řez do schránky jako hodnoty oddělené čárkami</translation>
    </message>
    <message>
        <source>Copy &amp;Picture</source>
        <translation>Kopírovat &amp;obrázek</translation>
    </message>
    <message>
        <source>Put the plot on the clipboard as a picture</source>
        <translation>Dát graf do schránky jako obrázek</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>&amp;Smazat</translation>
    </message>
    <message>
        <source>Take the line away</source>
        <translation>Odstranit čáru</translation>
    </message>
    <message>
        <source>Length %1   height %2 to %3</source>
        <translation>Délka %1   výška %2 až %3</translation>
    </message>
    <message>
        <source>At %1</source>
        <translation>V %1</translation>
    </message>
    <message>
        <source>height %1</source>
        <translation>výška %1</translation>
    </message>
    <message>
        <source>no ground</source>
        <translation>bez povrchu</translation>
    </message>
    <message>
        <source>reference %1</source>
        <translation>vzor %1</translation>
    </message>
    <message>
        <source>difference %1</source>
        <translation>rozdíl %1</translation>
    </message>
</context>
<context>
    <name>views::ProfilePlot</name>
    <message>
        <source>Cross-section: height over distance</source>
        <translation>Řez: výška podle vzdálenosti</translation>
    </message>
    <message>
        <source>Press “Pick” and draw a line over the terrain, from one end to the other.</source>
        <translation>Stiskněte „Vést“ a nakreslete přes terén čáru od jednoho konce ke druhému.</translation>
    </message>
    <message>
        <source>Distance (%1)</source>
        <translation>Vzdálenost (%1)</translation>
    </message>
    <message>
        <source>Height (%1)</source>
        <translation>Výška (%1)</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Vzor</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Nyní</translation>
    </message>
    <message>
        <source>heights ×%1</source>
        <translation>výšky ×%1</translation>
    </message>
</context>
<context>
    <name>views::QualityPanel</name>
    <message>
        <source>Quality</source>
        <translation>Kvalita</translation>
    </message>
    <message>
        <source>Settings of the chosen codec are searched for that give this quality in the smallest file.</source>
        <translation>Hledá se nastavení zvoleného kodeku, které dá tuto kvalitu v nejmenším souboru.</translation>
    </message>
    <message>
        <source>KG error at most %1 %</source>
        <translation>chyba KG nejvýše %1 %</translation>
    </message>
    <message>
        <source>&amp;Quality:</source>
        <translation>Kva&amp;lita:</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cíl</translation>
    </message>
    <message>
        <source>KG error</source>
        <translation>Chyba KG</translation>
    </message>
    <message>
        <source>Largest error</source>
        <translation>Největší chyba</translation>
    </message>
    <message>
        <source>File size</source>
        <translation>Velikost souboru</translation>
    </message>
    <message>
        <source>F&amp;ind Settings</source>
        <translation>&amp;Najít nastavení</translation>
    </message>
    <message>
        <source>Search settings of the chosen codec that reach the target</source>
        <translation>Hledat nastavení zvoleného kodeku, které cíle dosáhne</translation>
    </message>
    <message>
        <source>&amp;At most:</source>
        <translation>Nejv&amp;ýše:</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zastavit</translation>
    </message>
    <message>
        <source>Expected:</source>
        <translation>Očekává se:</translation>
    </message>
    <message>
        <source>% of the diagonal</source>
        <translation>% úhlopříčky</translation>
    </message>
    <message>
        <source>kB</source>
        <translation>kB</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Zastaveno.</translation>
    </message>
    <message>
        <source>%1
%2, %3 bits per frame and vertex
KG error %4</source>
        <translation>%1
%2, %3 bitů na snímek a vrchol
chyba KG %4</translation>
    </message>
    <message>
        <source>%1, %2 bits per frame and vertex, KG error %3</source>
        <translation>%1, %2 bitů na snímek a vrchol, chyba KG %3</translation>
    </message>
    <message>
        <source>Trying… %1 %</source>
        <translation>Zkouší se… %1 %</translation>
    </message>
</context>
<context>
    <name>views::Quantities</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
</context>
<context>
    <name>views::RatePlot</name>
    <message>
        <source>Size and error of what was tried</source>
        <translation>Velikost a chyba toho, co se zkoušelo</translation>
    </message>
    <message>
        <source>What is tried appears here.</source>
        <translation>Tady se objeví, co se zkusí.</translation>
    </message>
    <message>
        <source>bits per frame and vertex</source>
        <translation>bitů na snímek a vrchol</translation>
    </message>
    <message>
        <source>KG error, %</source>
        <translation>chyba KG, %</translation>
    </message>
</context>
<context>
    <name>views::RenameDialog</name>
    <message>
        <source>Rename Animation</source>
        <translation>Přejmenovat animaci</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Přejmenovat</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Jméno</translation>
    </message>
    <message>
        <source>&amp;Name:</source>
        <translation>&amp;Jméno:</translation>
    </message>
</context>
<context>
    <name>views::ResampleDialog</name>
    <message>
        <source>Resample Animation</source>
        <translation>Převzorkovat animaci</translation>
    </message>
    <message>
        <source>&amp;Resample</source>
        <translation>&amp;Převzorkovat</translation>
    </message>
    <message>
        <source>New frame rate</source>
        <translation>Nová snímková frekvence</translation>
    </message>
    <message>
        <source>frames per second</source>
        <translation>snímků za sekundu</translation>
    </message>
    <message>
        <source>&amp;New frame rate:</source>
        <translation>&amp;Nová snímková frekvence:</translation>
    </message>
    <message>
        <source>That would make %1 frames; %2 are allowed.</source>
        <translation>Vzniklo by %1 snímků; povoleno je jich nejvýše %2.</translation>
    </message>
    <message>
        <source>Frames: %1 → %2. The speed stays; frames in between are blended.</source>
        <translation>Snímky: %1 → %2. Rychlost zůstává; mezilehlé snímky se prolínají.</translation>
    </message>
</context>
<context>
    <name>views::SceneViewport</name>
    <message>
        <source>The graphics driver refused a shader:
%1</source>
        <translation>Ovladač grafické karty odmítl shader:
%1</translation>
    </message>
</context>
<context>
    <name>views::ScreenshotDialog</name>
    <message>
        <source>Save Screenshot</source>
        <translation>Uložit obrázek</translation>
    </message>
    <message>
        <source>Output File</source>
        <translation>Výstupní soubor</translation>
    </message>
    <message>
        <source>PNG Pictures (%1)</source>
        <translation>Obrázky PNG (%1)</translation>
    </message>
    <message>
        <source>&amp;Output file:</source>
        <translation>&amp;Výstupní soubor:</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 pixelů</translation>
    </message>
</context>
<context>
    <name>views::Statistics</name>
    <message>
        <source>Vertices</source>
        <translation>Vrcholy</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Trojúhelníky</translation>
    </message>
    <message>
        <source>Frames/s</source>
        <translation>Snímky/s</translation>
    </message>
    <message>
        <source>Decode</source>
        <translation>Dekódování</translation>
    </message>
    <message>
        <source>Upload</source>
        <translation>Přenos</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Kreslení</translation>
    </message>
    <message>
        <source>Vertex error</source>
        <translation>Chyba vrcholů</translation>
    </message>
    <message>
        <source>% of diagonal</source>
        <translation>% úhlopříčky</translation>
    </message>
    <message>
        <source>length</source>
        <translation>délka</translation>
    </message>
    <message>
        <source>this frame</source>
        <translation>tento snímek</translation>
    </message>
    <message>
        <source>all frames</source>
        <translation>všechny snímky</translation>
    </message>
</context>
<context>
    <name>views::StrokeController</name>
    <message>
        <source>The ground to restore is still being copied. Try again in a moment.</source>
        <translation>Povrch k obnovení se ještě kopíruje. Zkuste to za okamžik znovu.</translation>
    </message>
</context>
<context>
    <name>views::TerrainViewport</name>
    <message>
        <source>Terrain</source>
        <translation>Terén</translation>
    </message>
    <message>
        <source>The terrain in 3D. Plus and minus zoom, Home shows all of it. While you sculpt, arrow keys move the tool and Space presses and lifts it; with Ctrl they turn the terrain.</source>
        <translation>Terén v prostoru. Plus a minus přibližují, Home ukáže celý terén. Při tvarování šipky posouvají nástroj a mezerník ho přitlačí a zvedne; s Ctrl terénem otáčejí.</translation>
    </message>
</context>
<context>
    <name>views::TimelineDock</name>
    <message>
        <source>Timeline</source>
        <translation>Časová osa</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Přehrát</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Zastavit</translation>
    </message>
    <message>
        <source>Previous &amp;Frame</source>
        <translation>&amp;Předchozí snímek</translation>
    </message>
    <message>
        <source>&amp;Next Frame</source>
        <translation>&amp;Další snímek</translation>
    </message>
    <message>
        <source>Ten Frames Back</source>
        <translation>O deset snímků zpět</translation>
    </message>
    <message>
        <source>Ten Frames On</source>
        <translation>O deset snímků dál</translation>
    </message>
    <message>
        <source>F&amp;irst Frame</source>
        <translation>P&amp;rvní snímek</translation>
    </message>
    <message>
        <source>&amp;Last Frame</source>
        <translation>P&amp;oslední snímek</translation>
    </message>
    <message>
        <source>Play &amp;Backwards</source>
        <translation>Přehrávat p&amp;ozpátku</translation>
    </message>
    <message>
        <source>Play &amp;Once</source>
        <translation>Přehrát &amp;jednou</translation>
    </message>
    <message>
        <source>&amp;Repeat</source>
        <translation>&amp;Opakovat</translation>
    </message>
    <message>
        <source>Ping-Pon&amp;g</source>
        <translation>&amp;Tam a zpět</translation>
    </message>
    <message>
        <source>Start Loop &amp;Here</source>
        <translation>&amp;Začít smyčku zde</translation>
    </message>
    <message>
        <source>&amp;End Loop Here</source>
        <translation>&amp;Ukončit smyčku zde</translation>
    </message>
    <message>
        <source>Loop &amp;All Frames</source>
        <translation>Smyčka přes &amp;všechny snímky</translation>
    </message>
    <message>
        <source>Show Ever&amp;y Frame</source>
        <translation>Zobrazit &amp;každý snímek</translation>
    </message>
    <message>
        <source>The current frame. Drag the marks above the ruler to change the loop range.</source>
        <translation>Aktuální snímek. Tažením značek nad pravítkem změníte rozsah smyčky.</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Snímek</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Čas</translation>
    </message>
    <message>
        <source>Time / duration, minutes and seconds</source>
        <translation>Čas / délka, minuty a sekundy</translation>
    </message>
    <message>
        <source>Frames/s:</source>
        <translation>Snímky/s:</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>Snímky za sekundu</translation>
    </message>
    <message>
        <source>Frames per second of playback, 1 to 120</source>
        <translation>Snímky za sekundu při přehrávání, 1 až 120</translation>
    </message>
    <message>
        <source>Real Time</source>
        <translation>Reálný čas</translation>
    </message>
    <message>
        <source>Every Frame</source>
        <translation>Každý snímek</translation>
    </message>
    <message>
        <source>Pacing</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Real Time drops frames where drawing is too slow; Every Frame shows each and takes longer</source>
        <translation>Reálný čas vynechává snímky, když kreslení nestačí; Každý snímek ukáže všechny a trvá déle</translation>
    </message>
    <message>
        <source> / %1</source>
        <extracomment>After the number of the current frame: how many there are.</extracomment>
        <translation> / %1</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pozastavit</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Go to &amp;Worst Frame</source>
        <translation>Na nej&amp;horší snímek</translation>
    </message>
</context>
<context>
    <name>views::TimelineSlider</name>
    <message>
        <source>Loop range %1 - %2</source>
        <translation>Rozsah smyčky %1 - %2</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Snímek %1</translation>
    </message>
</context>
<context>
    <name>views::ToolsDock</name>
    <message>
        <source>Tools</source>
        <translation>Nástroje</translation>
    </message>
    <message>
        <source>Only Where</source>
        <translation>Jen tam, kde</translation>
    </message>
    <message>
        <source>Ready-made tools</source>
        <translation>Hotové nástroje</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Vlastní</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Souměrnost</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Vypnuto</translation>
    </message>
    <message>
        <source>Left and Right</source>
        <translation>Vlevo a vpravo</translation>
    </message>
    <message>
        <source>Front and Back</source>
        <translation>Vpředu a vzadu</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Obojí</translation>
    </message>
    <message>
        <source>Around</source>
        <translation>Dokola</translation>
    </message>
    <message>
        <source>&amp;Copies:</source>
        <translation>&amp;Kopie:</translation>
    </message>
    <message>
        <source>Number of copies</source>
        <translation>Počet kopií</translation>
    </message>
    <message>
        <source>N&amp;umber:</source>
        <translation>&amp;Počet:</translation>
    </message>
    <message>
        <source>Centre X</source>
        <translation>Střed X</translation>
    </message>
    <message>
        <source>Centre Y</source>
        <translation>Střed Y</translation>
    </message>
    <message>
        <source>Centre &amp;X:</source>
        <translation>Střed &amp;X:</translation>
    </message>
    <message>
        <source>Centre &amp;Y:</source>
        <translation>Střed &amp;Y:</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1:</translation>
    </message>
    <message>
        <source>Take &amp;Reference</source>
        <translation>Převzít &amp;vzor</translation>
    </message>
    <message>
        <source>From now on, Restore brings back the ground as it is at this moment. Until then it is that of the last save.</source>
        <translation>Od této chvíle Obnovit vrací povrch, jaký je v tomto okamžiku. Do té doby vrací ten, který byl naposledy uložen.</translation>
    </message>
</context>
<context>
    <name>views::TracePlot</name>
    <message>
        <source>%1 s ago</source>
        <translation>před %1 s</translation>
    </message>
    <message>
        <source>now</source>
        <translation>nyní</translation>
    </message>
</context>
<context>
    <name>views::TriesPanel</name>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Otevřít</translation>
    </message>
    <message>
        <source>Show in &amp;Folder</source>
        <translation>Zobrazit ve &amp;složce</translation>
    </message>
    <message>
        <source>Encodings made so far</source>
        <translation>Dosavadní kódování</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Nastavení</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Velikost</translation>
    </message>
    <message>
        <source>Raw : Size</source>
        <translation>Surová : výsledná</translation>
    </message>
    <message>
        <source>bpfv</source>
        <translation>bpfv</translation>
    </message>
    <message>
        <source>KG Error</source>
        <translation>Chyba KG</translation>
    </message>
    <message>
        <source>Largest Error</source>
        <translation>Největší chyba</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Doba</translation>
    </message>
    <message>
        <source>Bits per frame and vertex</source>
        <translation>Bity na snímek a vrchol</translation>
    </message>
    <message>
        <source>Error of Karni and Gotsman, per cent</source>
        <translation>Chyba podle Karniho a Gotsmana v procentech</translation>
    </message>
    <message>
        <source>Largest distance of a vertex, in per cent of the animation&apos;s diagonal</source>
        <translation>Největší vzdálenost vrcholu v procentech úhlopříčky animace</translation>
    </message>
    <message>
        <source>Encode &amp;Again with Other Settings</source>
        <translation>Zakódovat &amp;znovu s jiným nastavením</translation>
    </message>
    <message>
        <source>A later try has replaced the file</source>
        <translation>Soubor nahradil pozdější pokus</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; (replaced by a later try)</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; (nahrazen pozdějším pokusem)</translation>
    </message>
    <message>
        <source>%1 from %2 raw (%3), %4 bits per frame and vertex, encoded in %5</source>
        <translation>%1 ze surových %2 (%3), %4 bitu na snímek a vrchol, zakódováno za %5</translation>
    </message>
    <message>
        <source>KG error %1, RMSE %2, PSNR %3, largest vertex error %4 (%5 of the diagonal, in frame %6)</source>
        <translation>Chyba KG %1, RMSE %2, PSNR %3, největší chyba vrcholu %4 (%5 úhlopříčky, ve snímku %6)</translation>
    </message>
</context>
<context>
    <name>views::TrimDialog</name>
    <message>
        <source>Trim Animation</source>
        <translation>Oříznout animaci</translation>
    </message>
    <message>
        <source>&amp;Trim</source>
        <translation>&amp;Oříznout</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>První snímek</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Poslední snímek</translation>
    </message>
    <message>
        <source>&amp;First frame:</source>
        <translation>&amp;První snímek:</translation>
    </message>
    <message>
        <source>&amp;Last frame:</source>
        <translation>P&amp;oslední snímek:</translation>
    </message>
    <message>
        <source>The first frame must not come after the last.</source>
        <translation>První snímek nesmí být až za posledním.</translation>
    </message>
    <message>
        <source>Frames: %1 → %2</source>
        <translation>Snímky: %1 → %2</translation>
    </message>
</context>
<context>
    <name>views::TurntableDialog</name>
    <message>
        <source>Export Turntable</source>
        <translation>Exportovat otáčení</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Složka</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Obrázky</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Směr</translation>
    </message>
    <message>
        <source>The scene turns to the right</source>
        <translation>Scéna se otáčí doprava</translation>
    </message>
    <message>
        <source>The scene turns to the left</source>
        <translation>Scéna se otáčí doleva</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Náhled</translation>
    </message>
    <message>
        <source>F&amp;older:</source>
        <translation>S&amp;ložka:</translation>
    </message>
    <message>
        <source>Pict&amp;ures:</source>
        <translation>O&amp;brázky:</translation>
    </message>
    <message>
        <source>&amp;Direction:</source>
        <translation>Smě&amp;r:</translation>
    </message>
    <message>
        <source>Pre&amp;view:</source>
        <translation>&amp;Náhled:</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s) of %1 × %2 pixels. At %3 pictures per second they last %4.</source>
        <translation>
            <numerusform>%n obrázek o %1 × %2 pixelech. Při %3 obrázcích za sekundu trvá %4.</numerusform>
            <numerusform>%n obrázky o %1 × %2 pixelech. Při %3 obrázcích za sekundu trvají %4.</numerusform>
            <numerusform>%n obrázků o %1 × %2 pixelech. Při %3 obrázcích za sekundu trvají %4.</numerusform>
        </translation>
    </message>
</context>
</TS>
