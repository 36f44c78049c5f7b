<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt_BR">
<context>
    <name>Archive</name>
    <message>
        <source>There is no such file</source>
        <translation>Esse arquivo não existe</translation>
    </message>
    <message>
        <source>The file is empty</source>
        <translation>O arquivo está vazio</translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>O arquivo não pode ser lido: %1</translation>
    </message>
    <message>
        <source>This is not a Dipwright project, or the file is cut off or damaged</source>
        <translation>Isto não é um projeto do Dipwright, ou o arquivo está truncado ou danificado</translation>
    </message>
    <message>
        <source>The file is cut off or damaged</source>
        <translation>O arquivo está truncado ou danificado</translation>
    </message>
    <message>
        <source>The file holds an entry with an unsafe path and is not opened</source>
        <translation>O arquivo contém uma entrada com caminho inseguro e não foi aberto</translation>
    </message>
    <message>
        <source>The file holds the entry %1 twice</source>
        <translation>O arquivo contém a entrada %1 duas vezes</translation>
    </message>
    <message>
        <source>The file is encrypted, save it without a password</source>
        <translation>O arquivo está criptografado; salve-o sem senha</translation>
    </message>
    <message>
        <source>The project lacks %1</source>
        <translation>Falta %1 no projeto</translation>
    </message>
    <message>
        <source>%1 in the project is cut off or damaged</source>
        <translation>%1 no projeto está truncado ou danificado</translation>
    </message>
    <message>
        <source>The file cannot be packed</source>
        <translation>O arquivo não pode ser compactado</translation>
    </message>
</context>
<context>
    <name>AtomicFile</name>
    <message>
        <source>it is a folder</source>
        <translation>é uma pasta</translation>
    </message>
    <message>
        <source>it may not be written</source>
        <translation>não há permissão para gravá-lo</translation>
    </message>
    <message>
        <source>another program is writing it at this moment, try again</source>
        <translation>outro programa está gravando-o neste momento, tente de novo</translation>
    </message>
    <message>
        <source>it does not reach the disk: %1</source>
        <translation>não chega ao disco: %1</translation>
    </message>
    <message>
        <source>The file cannot be written: %1</source>
        <translation>O arquivo não pode ser gravado: %1</translation>
    </message>
    <message>
        <source>its links lead to one another</source>
        <translation>seus links levam uns aos outros</translation>
    </message>
    <message>
        <source>it is no plain file</source>
        <translation>não é um arquivo comum</translation>
    </message>
</context>
<context>
    <name>BodyAppearance</name>
    <message>
        <source>Painted</source>
        <translation>Pintado</translation>
    </message>
    <message>
        <source>Not painted</source>
        <translation>Não pintado</translation>
    </message>
    <message>
        <source>Painted, by the shape</source>
        <translation>Pintado, pela forma</translation>
    </message>
</context>
<context>
    <name>Certainty</name>
    <message>
        <source>the film has too few points to be compared with one of half as many</source>
        <translation>o filme tem pontos de menos para ser comparado com um de metade deles</translation>
    </message>
    <message>
        <source>a coarser film does not follow the body at all</source>
        <translation>um filme mais grosso não acompanha o corpo de modo algum</translation>
    </message>
    <message>
        <source>Overhang (°)</source>
        <translation>Saliência (°)</translation>
    </message>
    <message>
        <source>Fading grip (°)</source>
        <translation>Aderência decrescente (°)</translation>
    </message>
    <message>
        <source>Tearing (times the length or area)</source>
        <translation>Rasgo (vezes o comprimento ou a área)</translation>
    </message>
    <message>
        <source>Gathering (mean stretch)</source>
        <translation>Franzimento (estiramento médio)</translation>
    </message>
    <message>
        <source>%1, %2 to %3 in place of %4: the sheet moves by up to %5 (95 % of it), %6 % of what is painted by more than %7, and %8 % is not painted any more.</source>
        <translation>%1, %2 a %3 em vez de %4: a folha se desloca em até %5 (95 % dela), %6 % do que é pintado em mais de %7, e %8 % deixam de ser pintados.</translation>
    </message>
</context>
<context>
    <name>VerdictPanel</name>
    <message>
        <source>Setting</source>
        <translation>Definição</translation>
    </message>
    <message>
        <source>Places of %1:</source>
        <translation>Lugares de %1:</translation>
    </message>
</context>
<context>
    <name>CheckedSolver</name>
    <message>
        <source>it threw an unknown exception</source>
        <translation>ele lançou uma exceção desconhecida</translation>
    </message>
    <message>
        <source>it gave points a state that there is none of</source>
        <translation>ele deu a pontos um estado que não existe</translation>
    </message>
    <message>
        <source>it gave points a mark that there is none of</source>
        <translation>ele deu a pontos uma marca que não existe</translation>
    </message>
    <message>
        <source>it gave no film</source>
        <translation>ele não deu nenhum filme</translation>
    </message>
    <message>
        <source>it stopped by itself</source>
        <translation>ele parou por conta própria</translation>
    </message>
    <message>
        <source>it left films of a batch empty</source>
        <translation>ele deixou vazios filmes de um lote</translation>
    </message>
    <message>
        <source>it told steps or a descent that cannot be</source>
        <translation>ele informou passos ou uma descida que não podem ser</translation>
    </message>
    <message>
        <source>it does not come forward</source>
        <translation>ele não avança</translation>
    </message>
    <message>
        <source>it told figures of its equilibrium that cannot be</source>
        <translation>ele informou valores do seu equilíbrio que não podem ser</translation>
    </message>
</context>
<context>
    <name>ColourNote</name>
    <message>
        <source>%1 is in CMYK and names no ICC profile: its colours are guessed by a formula and can be far off; save it with its profile, or as sRGB</source>
        <translation>%1: imagem em CMYK sem perfil ICC; as cores são estimadas por uma fórmula e podem estar bem erradas; salve-a com o seu perfil ou como sRGB</translation>
    </message>
    <message>
        <source>%1 has colours that are not kept as they are: %2 % of its pixels lie beyond BT.2020, in which pictures are kept, and are printed less saturated; save it in a smaller space, such as Adobe RGB, to choose how</source>
        <translation>%1: há cores que não se mantêm como são; %2 % dos pixels estão fora do BT.2020, em que as imagens são guardadas, e são impressos menos saturados; salve-a em um espaço menor, como Adobe RGB, para decidir como</translation>
    </message>
</context>
<context>
    <name>Cradle</name>
    <message>
        <source>%1: the body tips out of its cradle where it is not fixed; what stays dry does not lie on all sides of its middle. Fix it through the bore, or turn the pose</source>
        <translation>%1: o corpo tomba do seu berço onde não está fixado; o que fica seco não está em todos os lados do seu meio. Fixe-o pelo furo ou gire a pose</translation>
    </message>
    <message>
        <source>%1: nothing keeps the body from sliding sideways in its cradle, for what stays dry is flat; mark its place and fix it there</source>
        <translation>%1: nada impede o corpo de escorregar de lado no seu berço, pois o que fica seco é plano; marque o seu lugar e fixe-o ali</translation>
    </message>
    <message>
        <source>%1: the cradle lies on %2 mm² of paint of an earlier dip; line it there with %3 mm of soft felt or foam</source>
        <translation>%1: o berço apoia-se em %2 mm² de tinta de um mergulho anterior; forre-o ali com %3 mm de feltro macio ou espuma</translation>
    </message>
    <message>
        <source>%1: the cradle&apos;s plate has no room for arrow and job; write them on it</source>
        <translation>%1: a placa do berço não tem espaço para a seta e o trabalho; escreva-os nela</translation>
    </message>
    <message>
        <source>%1: there is no cradle, for all that could hold the body is painted by an earlier dip; allow it with cradle.on_paint, through padding, or turn the pose</source>
        <translation>%1: não há berço, pois tudo que poderia segurar o corpo foi pintado por um mergulho anterior; permita-o com cradle.on_paint, através de um forro, ou gire a pose</translation>
    </message>
    <message>
        <source>%1: there is no cradle, for the film reaches all that could hold the body; dip it less deep or turn the pose</source>
        <translation>%1: não há berço, pois o filme alcança tudo que poderia segurar o corpo; mergulhe-o menos fundo ou gire a pose</translation>
    </message>
    <message>
        <source>Forming the cradle</source>
        <translation>Formando o berço</translation>
    </message>
    <message>
        <source>Checking the cradle</source>
        <translation>Verificando o berço</translation>
    </message>
    <message>
        <source>Looking for what stays dry</source>
        <translation>Procurando o que fica seco</translation>
    </message>
</context>
<context>
    <name>Dip</name>
    <message>
        <source>Dipping</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>The simulation became unstable; choose a smaller time step or contact travel</source>
        <translation>A simulação ficou instável; escolha um passo de tempo ou avanço de contato menor</translation>
    </message>
    <message>
        <source>The solver failed: %1</source>
        <translation>O solucionador falhou: %1</translation>
    </message>
    <message>
        <source>The solver failed with an unknown exception</source>
        <translation>O solucionador falhou com uma exceção desconhecida</translation>
    </message>
    <message>
        <source>With these cells the film would have %1 million points, and it may have %2; give it larger cells</source>
        <translation>Com estas células o filme teria %1 milhões de pontos, e pode ter %2; dê-lhe células maiores</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, %2 % of what is painted, depend on marked film. %3.</source>
        <translation>%1, %2 % do que é pintado, dependem de filme marcado. %3.</translation>
    </message>
    <message>
        <source>The body does not meet the film; move it over the film, choose a larger film, or give the film smaller cells or more points</source>
        <translation>O corpo não encontra o filme; mova-o sobre o filme, escolha um filme maior ou dê ao filme células menores ou mais pontos</translation>
    </message>
    <message>
        <source>The body is not found: parts of it are only %1 mm thick, and the distance field has cells of %2 mm; make them thicker, or dip a smaller part of it</source>
        <translation>O corpo não é encontrado: partes dele têm só %1 mm de espessura, e o campo de distância tem células de %2 mm; torne-as mais espessas ou mergulhe uma parte menor dele</translation>
    </message>
    <message>
        <source>choose a film of at least %1 × %2 mm</source>
        <translation>escolha um filme de pelo menos %1 × %2 mm</translation>
    </message>
    <message>
        <source>no film is larger than %1 mm: check the model&apos;s size and unit</source>
        <translation>nenhum filme é maior que %1 mm: verifique o tamanho e a unidade do modelo</translation>
    </message>
    <message>
        <source>The body is larger than the film on all sides, %1 × %2 mm on the water, and no film is left to go round it; %3</source>
        <translation>O corpo é maior que o filme em todos os lados, %1 × %2 mm sobre a água, e não sobra filme para envolvê-lo; %3</translation>
    </message>
    <message>
        <source>Torn film</source>
        <translation>Filme rasgado</translation>
    </message>
    <message>
        <source>Film that did not converge</source>
        <translation>Filme que não convergiu</translation>
    </message>
    <message>
        <source>Released film</source>
        <translation>Filme solto</translation>
    </message>
</context>
<context>
    <name>DipCache</name>
    <message>
        <source>The dips cannot be kept: %1</source>
        <translation>As imersões não podem ser guardadas: %1</translation>
    </message>
    <message>
        <source>Reading the kept dips</source>
        <translation>Lendo as imersões guardadas</translation>
    </message>
    <message>
        <source>The kept dips are damaged and not used; a run makes them again</source>
        <translation>As imersões guardadas estão danificadas e não são usadas; uma execução as refaz</translation>
    </message>
</context>
<context>
    <name>DipJob</name>
    <message>
        <source>Simulating the dip</source>
        <translation>Simulando a imersão</translation>
    </message>
    <message>
        <source>Preparing the views</source>
        <translation>Preparando as vistas</translation>
    </message>
</context>
<context>
    <name>DipPlayback</name>
    <message>
        <source>%1 (%2 deep)</source>
        <translation>%1 (a %2 de profundidade)</translation>
    </message>
    <message>
        <source>First contact</source>
        <translation>Primeiro contato</translation>
    </message>
    <message>
        <source>Film tears</source>
        <translation>O filme rasga</translation>
    </message>
    <message>
        <source>Air is trapped under the body</source>
        <translation>Ar fica preso sob o corpo</translation>
    </message>
    <message>
        <source>Film is released at an overhang</source>
        <translation>O filme se solta numa saliência</translation>
    </message>
</context>
<context>
    <name>FileLock</name>
    <message>
        <source>%1 on %2, process %3</source>
        <translation>%1 em %2, processo %3</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>outro programa</translation>
    </message>
    <message>
        <source>an unknown machine</source>
        <translation>uma máquina desconhecida</translation>
    </message>
</context>
<context>
    <name>FilmFacts</name>
    <message>
        <source>%1: cells of %2, %3 × %4 points</source>
        <translation>%1: células de %2, %3 × %4 pontos</translation>
    </message>
    <message>
        <source>%1, about %2 s</source>
        <translation>%1, cerca de %2 s</translation>
    </message>
</context>
<context>
    <name>FilmFields</name>
    <message>
        <source>W</source>
        <comment>width</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>H</source>
        <comment>height</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>Whether this side of the film floats freely or is held by a barrier in the tank.</source>
        <translation>Se este lado do filme flutua livre ou é preso por uma barreira no tanque.</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Livre</translation>
    </message>
    <message>
        <source>Held by a barrier</source>
        <translation>Presa por uma barreira</translation>
    </message>
    <message>
        <source>Swell</source>
        <translation>Inchamento</translation>
    </message>
    <message>
        <source>How much the wetted film has grown over the printed one, across and down. Measure it: it is the first number to calibrate, and the sheet is printed smaller by it.</source>
        <translation>Quanto o filme molhado cresceu em relação ao impresso, na largura e na altura. Meça: é o primeiro número a calibrar, e a folha é impressa menor por ele.</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxação</translation>
    </message>
    <message>
        <source>How fast stress in the floating film decays. An elastic film remembers its shape for ever; a viscous one, at 0 s, forgets at once.</source>
        <translation>Com que rapidez a tensão no filme flutuante diminui. Um filme elástico lembra sua forma para sempre; um viscoso, com 0 s, esquece na hora.</translation>
    </message>
    <message>
        <source>Elastic</source>
        <translation>Elástico</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Crescimento</translation>
    </message>
    <message>
        <source>How fast the film goes on growing while it floats, in a second of the dip and at its begin. What is on the body grows no more.</source>
        <translation>Com que rapidez o filme continua a crescer enquanto flutua, por segundo e no início da imersão. O que está sobre o corpo já não cresce.</translation>
    </message>
    <message>
        <source>Grows by at most</source>
        <translation>Cresce no máximo</translation>
    </message>
    <message>
        <source>Contact distance</source>
        <translation>Distância de contato</translation>
    </message>
    <message>
        <source>How near a film point has to come to the surface to touch it.</source>
        <translation>Quão perto um ponto do filme deve chegar da superfície para tocá-la.</translation>
    </message>
    <message>
        <source>Grip fades over</source>
        <translation>Aderência diminui ao longo de</translation>
    </message>
    <message>
        <source>So far before the overhang the body begins to lose its grip on the film. A guess: no film was measured.</source>
        <translation>A essa distância antes do ressalto o corpo começa a perder a aderência ao filme. Uma suposição: nenhum filme foi medido.</translation>
    </message>
    <message>
        <source>Gathers below</source>
        <translation>Franze abaixo de</translation>
    </message>
    <message>
        <source>Film pushed together to a mean stretch below this gathers, and hardly resists any more. A guess: no film was measured.</source>
        <translation>O filme comprimido abaixo deste estiramento médio franze e quase já não resiste. Uma suposição: nenhum filme foi medido.</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Direita</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Em cima</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Embaixo</translation>
    </message>
    <message>
        <source>Ink thins by</source>
        <translation>A tinta afina por</translation>
    </message>
    <message>
        <source>The exponent n: ink printed with density D shows D·J^−n where film is stretched to J times its area. 1 for dye, 0 for dots that hide what is behind them. A guess, taken for inks without tones.</source>
        <translation>O expoente n: tinta impressa com densidade D mostra D·J^−n onde o filme está estirado a J vezes a sua área. 1 para corante, 0 para pontos que escondem o que está atrás. Uma estimativa, usada para tintas sem tons medidos.</translation>
    </message>
    <message>
        <source>C</source>
        <comment>cyan</comment>
        <translation>C</translation>
    </message>
    <message>
        <source>M</source>
        <comment>magenta</comment>
        <translation>M</translation>
    </message>
    <message>
        <source>Y</source>
        <comment>yellow</comment>
        <translation>Y</translation>
    </message>
    <message>
        <source>Black and white</source>
        <translation>Preto e branco</translation>
    </message>
    <message>
        <source>The same of black and white ink, which printers in CMYK have: there each ink is made up for by itself, after separation.</source>
        <translation>O mesmo da tinta preta e da branca, que impressoras em CMYK têm: ali cada tinta é compensada por si, depois da separação.</translation>
    </message>
    <message>
        <source>K</source>
        <comment>black</comment>
        <translation>K</translation>
    </message>
    <message>
        <source>W</source>
        <comment>white</comment>
        <translation>B</translation>
    </message>
    <message>
        <source>Ink, measured</source>
        <translation>Tinta, medida</translation>
    </message>
    <message>
        <source>What a step wedge told, tone by tone: ink, density, exponent, bend, greatest stretch (dipwright-cli profile wedge).</source>
        <translation>O que uma cunha de tons mostrou, tom a tom: tinta, densidade, expoente, curvatura, maior estiramento (dipwright-cli profile wedge).</translation>
    </message>
    <message>
        <source>As in the project</source>
        <translation>Como no projeto</translation>
    </message>
    <message>
        <source>Tears at</source>
        <translation>Rasga em</translation>
    </message>
    <message>
        <source>How many times its length or its area film can be stretched before it tears. Torn film is marked and not painted.</source>
        <translation>Quantas vezes o comprimento ou a área do filme pode ser esticado antes de rasgar. Filme rasgado é marcado e não pinta.</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Ressalto</translation>
    </message>
    <message>
        <source>Film holds on faces that turn upwards by no more than this.</source>
        <translation>O filme adere a faces que se voltam para cima até este ângulo.</translation>
    </message>
    <message>
        <source>Total growth of the floating film after a long time, relative to its length at the start of the dip. 0: the film does not grow.</source>
        <translation>Crescimento total do filme flutuante depois de muito tempo, em relação ao comprimento no início da imersão. 0: o filme não cresce.</translation>
    </message>
</context>
<context>
    <name>FilmMeasured</name>
    <message>
        <source>not measured</source>
        <translation>não medido</translation>
    </message>
    <message>
        <source>measured on %1</source>
        <translation>medido em %1</translation>
    </message>
    <message>
        <source>swell</source>
        <translation>inchamento</translation>
    </message>
    <message>
        <source>growth</source>
        <translation>crescimento</translation>
    </message>
    <message>
        <source>relaxation</source>
        <translation>relaxação</translation>
    </message>
    <message>
        <source>%1 measured on %2</source>
        <translation>%1: medido em %2</translation>
    </message>
    <message>
        <source>%1 not measured</source>
        <translation>%1: não medido</translation>
    </message>
    <message>
        <source>None: a film that was not measured</source>
        <translation>Nenhum: um filme que não foi medido</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>FolderTransaction</name>
    <message>
        <source>The results cannot be written, %1 is not a folder</source>
        <translation>Os resultados não podem ser gravados; %1 não é uma pasta</translation>
    </message>
    <message>
        <source>The results cannot be written: %1</source>
        <translation>Os resultados não podem ser gravados: %1</translation>
    </message>
    <message>
        <source>The results cannot be moved into the folder, is a file there in use?</source>
        <translation>Os resultados não podem ser movidos para a pasta; algum arquivo ali está em uso?</translation>
    </message>
    <message>
        <source>%1 is in the way of the results; move it, or choose another folder</source>
        <translation>%1 está no caminho dos resultados; mova-o ou escolha outra pasta</translation>
    </message>
    <message>
        <source>Another program is writing results there (%1); wait for it, or choose another folder</source>
        <translation>Outro programa está gravando resultados ali (%1); espere por ele ou escolha outra pasta</translation>
    </message>
    <message>
        <source>The folder cannot be written, choose another</source>
        <translation>Não é possível gravar na pasta; escolha outra</translation>
    </message>
    <message>
        <source>The results are only in part moved into the folder; close what has files there open, and start the program again, which moves the rest</source>
        <translation>Os resultados foram movidos para a pasta só em parte; feche o que tem arquivos abertos ali e inicie o programa de novo, que move o resto</translation>
    </message>
    <message>
        <source>The results cannot be read again: %1</source>
        <translation>Os resultados não podem ser lidos de novo: %1</translation>
    </message>
    <message>
        <source>Earlier results there were not completed and cannot be now; close what has files there open, or move %1 out of it</source>
        <translation>Resultados anteriores ali não foram concluídos e não podem ser agora; feche o que tem arquivos abertos ali, ou mova %1 para fora</translation>
    </message>
    <message>
        <source>Somebody has moved or removed files of %1 while the results were written, and they are not complete; leave it alone and try again</source>
        <translation>Alguém moveu ou removeu arquivos de %1 enquanto os resultados eram gravados, e eles não estão completos; não mexa nessa pasta e tente de novo</translation>
    </message>
</context>
<context>
    <name>GuidePlaces</name>
    <message>
        <source>Dip ▸ Check Certainty</source>
        <translation>Imersão ▸ Verificar confiabilidade</translation>
    </message>
    <message>
        <source>Dip ▸ Tolerances</source>
        <translation>Imersão ▸ Tolerâncias</translation>
    </message>
    <message>
        <source>File ▸ New Project</source>
        <translation>Arquivo ▸ Novo projeto</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Meio</translation>
    </message>
    <message>
        <source>timeline</source>
        <translation>linha do tempo</translation>
    </message>
    <message>
        <source>Reload Model</source>
        <translation>Recarregar modelo</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Junção</translation>
    </message>
    <message>
        <source>File ▸ Print</source>
        <translation>Arquivo ▸ Imprimir</translation>
    </message>
    <message>
        <source>ICC profile</source>
        <translation>perfil ICC</translation>
    </message>
    <message>
        <source>Dip ▸ Find Poses</source>
        <translation>Imersão ▸ Procurar poses</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Estiramento</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textura</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Prova</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Folha</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Relatório</translation>
    </message>
    <message>
        <source>File ▸ Print History</source>
        <translation>Arquivo ▸ Histórico de impressão</translation>
    </message>
    <message>
        <source>File ▸ Calibrate Printer</source>
        <translation>Arquivo ▸ Calibrar impressora</translation>
    </message>
    <message>
        <source>Edit ▸ Profiles</source>
        <translation>Editar ▸ Perfis</translation>
    </message>
    <message>
        <source>Measuring a dipped part</source>
        <translation>Medir uma peça mergulhada</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>As Built</source>
        <translation>Como saiu</translation>
    </message>
    <message>
        <source>Measuring a film</source>
        <translation>Medir um filme</translation>
    </message>
    <message>
        <source>File ▸ Snapshots</source>
        <translation>Arquivo ▸ Instantâneos</translation>
    </message>
    <message>
        <source>File ▸ Job Queue</source>
        <translation>Arquivo ▸ Fila de trabalhos</translation>
    </message>
    <message>
        <source>log</source>
        <translation>registro</translation>
    </message>
</context>
<context>
    <name>ImmersionEdits</name>
    <message>
        <source>Add Immersion</source>
        <translation>Adicionar imersão</translation>
    </message>
    <message>
        <source>Immersion %1</source>
        <translation>Imersão %1</translation>
    </message>
    <message>
        <source>Remove Immersion</source>
        <translation>Remover imersão</translation>
    </message>
    <message>
        <source>Swap Immersions</source>
        <translation>Trocar imersões</translation>
    </message>
    <message>
        <source>Take Pose</source>
        <translation>Assumir pose</translation>
    </message>
</context>
<context>
    <name>InspectionEdits</name>
    <message>
        <source>Add Photos</source>
        <translation>Adicionar fotos</translation>
    </message>
    <message>
        <source>Remove Photo</source>
        <translation>Remover foto</translation>
    </message>
    <message>
        <source>Add Pair of Places</source>
        <translation>Adicionar par de pontos</translation>
    </message>
    <message>
        <source>Move Place in Photo</source>
        <translation>Mover ponto na foto</translation>
    </message>
    <message>
        <source>Remove Pair of Places</source>
        <translation>Remover par de pontos</translation>
    </message>
    <message>
        <source>Change Film on the Water</source>
        <translation>Alterar filme na água</translation>
    </message>
    <message>
        <source>Keep Part</source>
        <translation>Guardar peça</translation>
    </message>
    <message>
        <source>Correct the Next Sheets</source>
        <translation>Corrigir as próximas folhas</translation>
    </message>
    <message>
        <source>Change Strength of Correction</source>
        <translation>Alterar intensidade da correção</translation>
    </message>
    <message>
        <source>Use What Was Fitted</source>
        <translation>Usar o ajuste</translation>
    </message>
    <message>
        <source>Measured %1</source>
        <translation>Medido em %1</translation>
    </message>
</context>
<context>
    <name>InspectionProfile</name>
    <message>
        <source>Save to Profile</source>
        <translation>Salvar no perfil</translation>
    </message>
    <message>
        <source>Name of the film profile, an old or a new one</source>
        <translation>Nome do perfil de filme, existente ou novo</translation>
    </message>
    <message>
        <source>The film profile %1 has what was measured</source>
        <translation>O perfil de filme %1 recebeu a medição</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Pose Search</source>
        <translation>Busca de poses</translation>
    </message>
    <message>
        <source>Artwork</source>
        <translation>Arte</translation>
    </message>
</context>
<context>
    <name>MarkEdits</name>
    <message>
        <source>Mark for the Join</source>
        <translation>Marca para a junção</translation>
    </message>
    <message>
        <source>Mark a Zone</source>
        <translation>Marcar uma zona</translation>
    </message>
    <message>
        <source>Remove Mark</source>
        <translation>Remover marca</translation>
    </message>
    <message>
        <source>Remove Marks</source>
        <translation>Remover marcas</translation>
    </message>
</context>
<context>
    <name>ModelEdits</name>
    <message>
        <source>Change Size</source>
        <translation>Mudar tamanho</translation>
    </message>
</context>
<context>
    <name>ModelImport</name>
    <message>
        <source>Reading the model</source>
        <translation>Lendo o modelo</translation>
    </message>
    <message>
        <source>Immersion %1</source>
        <translation>Imersão %1</translation>
    </message>
    <message>
        <source>Reload Model</source>
        <translation>Recarregar modelo</translation>
    </message>
    <message>
        <source>Replace Model</source>
        <translation>Trocar modelo</translation>
    </message>
    <message>
        <source>Replace Texture</source>
        <translation>Trocar textura</translation>
    </message>
    <message>
        <source>Reading the texture</source>
        <translation>Lendo a textura</translation>
    </message>
    <message>
        <source>The model names files outside its own folder:</source>
        <translation>O modelo cita arquivos fora da sua pasta:</translation>
    </message>
    <message>
        <source>The project, as it was opened, names these files:</source>
        <translation>O projeto, tal como foi aberto, cita estes arquivos:</translation>
    </message>
</context>
<context>
    <name>Motion</name>
    <message>
        <source>The template of the motion names {%1}, which there is not; use one of %2</source>
        <translation>O modelo do movimento cita {%1}, que não existe; use um de %2</translation>
    </message>
</context>
<context>
    <name>OutOfProcessSolver</name>
    <message>
        <source>it cannot be given a process of its own: %1</source>
        <translation>não foi possível dar-lhe um processo próprio: %1</translation>
    </message>
    <message>
        <source>it was at one step for more than %1 s and was stopped</source>
        <translation>ele ficou mais de %1 s em um passo e foi encerrado</translation>
    </message>
    <message>
        <source>its process was killed, perhaps for want of memory</source>
        <translation>o processo dele foi morto, talvez por falta de memória</translation>
    </message>
    <message>
        <source>it crashed (%1)</source>
        <translation>ele travou (%1)</translation>
    </message>
    <message>
        <source>it ended its process (%1)</source>
        <translation>ele encerrou o próprio processo (%1)</translation>
    </message>
    <message>
        <source>it answered with more than there can be and was stopped</source>
        <translation>respondeu com mais do que pode haver e foi parado</translation>
    </message>
</context>
<context>
    <name>PhysicsValidation</name>
    <message>
        <source>%1 film, %2 cells in the contact radius</source>
        <translation>filme %1, %2 células no raio de contato</translation>
    </message>
    <message>
        <source>arc length from the pole (mm)</source>
        <translation>comprimento de arco desde o polo (mm)</translation>
    </message>
    <message>
        <source>film radius (mm)</source>
        <translation>raio do filme (mm)</translation>
    </message>
    <message>
        <source>body</source>
        <translation>corpo</translation>
    </message>
    <message>
        <source>film</source>
        <translation>filme</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>células</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>rms</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>média</translation>
    </message>
    <message>
        <source>max</source>
        <translation>máx</translation>
    </message>
    <message>
        <source>axis−diag</source>
        <translation>eixo−diag</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>passos</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>ok</translation>
    </message>
    <message>
        <source>FAILED</source>
        <translation>FALHOU</translation>
    </message>
    <message>
        <source>Dipping</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>The solver failed: %1</source>
        <translation>O solucionador falhou: %1</translation>
    </message>
    <message>
        <source>physics validation</source>
        <translation>validação da física</translation>
    </message>
    <message>
        <source>The film never touched the body; the solver cannot be used</source>
        <translation>O filme nunca tocou o corpo; o solucionador não pode ser usado</translation>
    </message>
    <message>
        <source>Sphere to 80°</source>
        <translation>Esfera até 80°</translation>
    </message>
    <message>
        <source>Flat spheroid 1 : 0.6</source>
        <translation>Esferoide achatado 1 : 0,6</translation>
    </message>
    <message>
        <source>Long spheroid 1 : 1.4</source>
        <translation>Esferoide alongado 1 : 1,4</translation>
    </message>
    <message>
        <source>Cone of %1°</source>
        <translation>Cone de %1°</translation>
    </message>
    <message>
        <source>viscous</source>
        <translation>viscoso</translation>
    </message>
    <message>
        <source>elastic</source>
        <translation>elástico</translation>
    </message>
    <message>
        <source>Flat face, 60 × 40 mm</source>
        <translation>Face plana, 60 × 40 mm</translation>
    </message>
    <message>
        <source>Inside of a torus to 80°</source>
        <translation>Interior de um toro até 80°</translation>
    </message>
    <message>
        <source>Lying cylinder to 80°</source>
        <translation>Cilindro deitado até 80°</translation>
    </message>
    <message>
        <source>Ellipsoid turned by 45°</source>
        <translation>Elipsoide girado de 45°</translation>
    </message>
    <message>
        <source>%1, %2 cells</source>
        <translation>%1, %2 células</translation>
    </message>
    <message>
        <source>Flat face</source>
        <translation>Face plana</translation>
    </message>
    <message>
        <source>free</source>
        <translation>livre</translation>
    </message>
    <message>
        <source>growing</source>
        <translation>em crescimento</translation>
    </message>
    <message>
        <source>Film before it is touched</source>
        <translation>Filme antes do contato</translation>
    </message>
</context>
<context>
    <name>Pipeline</name>
    <message>
        <source>%1 %2 × %3 mm</source>
        <translation>%1 %2 × %3 mm</translation>
    </message>
    <message>
        <source>1:1, swell %1 × %2 taken out</source>
        <translation>1:1, inchamento %1 × %2 descontado</translation>
    </message>
    <message>
        <source>The project has no model, import one first</source>
        <translation>O projeto não tem modelo; importe um primeiro</translation>
    </message>
    <message>
        <source>%1 failed and %2 took over: %3</source>
        <translation>%1 falhou e %2 assumiu: %3</translation>
    </message>
    <message>
        <source>Finding the film on the body</source>
        <translation>Localizando o filme no corpo</translation>
    </message>
    <message>
        <source>The body does not meet the film; move it over the film or choose a larger film</source>
        <translation>O corpo não encontra o filme; mova-o sobre o filme ou escolha um filme maior</translation>
    </message>
    <message>
        <source>The CPU takes over from %1: %2</source>
        <translation>A CPU assume o lugar de %1: %2</translation>
    </message>
    <message>
        <source>The model is not closed, what is inside is guessed</source>
        <translation>O modelo não é fechado; o interior é estimado</translation>
    </message>
    <message>
        <source>The model has no texture, its plain colours are printed</source>
        <translation>O modelo não tem textura; suas cores simples serão impressas</translation>
    </message>
    <message>
        <source>Writing the sheet of %1</source>
        <translation>Gravando a folha de %1</translation>
    </message>
    <message>
        <source>Writing the film of %1</source>
        <translation>Gravando o filme de %1</translation>
    </message>
    <message>
        <source>Writing the stretch of %1</source>
        <translation>Gravando o estiramento de %1</translation>
    </message>
    <message>
        <source>Moving the results in place</source>
        <translation>Movendo os resultados para o lugar</translation>
    </message>
    <message>
        <source>The film is too fine to be compared with one of %1 × %2 points, set half as many for the comparison</source>
        <translation>O filme é fino demais para ser comparado com um de %1 × %2 pontos; defina metade deles para a comparação</translation>
    </message>
    <message>
        <source>Comparing the sheets</source>
        <translation>Comparando as folhas</translation>
    </message>
    <message>
        <source>Writing the proof</source>
        <translation>Gravando a prova</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Gravando o relatório</translation>
    </message>
    <message>
        <source>Reversing the texture</source>
        <translation>Revertendo a textura</translation>
    </message>
    <message>
        <source>Varying the laws</source>
        <translation>Variando as leis</translation>
    </message>
    <message>
        <source>Writing the cradle of %1</source>
        <translation>Gravando o berço de %1</translation>
    </message>
    <message>
        <source>Writing the traveller</source>
        <translation>Gravando a ficha de acompanhamento</translation>
    </message>
    <message>
        <source>Writing the motion</source>
        <translation>Gravando o movimento</translation>
    </message>
    <message>
        <source>With a law varied the film does not follow the body; give the film smaller cells or more points</source>
        <translation>Com uma lei variada o filme não acompanha o corpo; dê ao filme células menores ou mais pontos</translation>
    </message>
    <message>
        <source>The body is smaller than the film&apos;s cells; give the film smaller cells or more points, or check the model&apos;s unit</source>
        <translation>O corpo é menor que as células do filme; dê ao filme células menores ou mais pontos, ou verifique a unidade do modelo</translation>
    </message>
    <message>
        <source>%1: the film&apos;s cells are coarse for this body, give the film smaller cells or more points</source>
        <translation>%1: as células do filme são grossas para este corpo; dê ao filme células menores ou mais pontos</translation>
    </message>
    <message>
        <source>%1 is better dipped after %2: along the join its film is drawn out %3 times and that of %2 %4 times, and the last film lies off so many times as far on the body as on the water</source>
        <translation>%1 fica melhor depois de %2: ao longo da junção seu filme é esticado %3 vezes e o de %2, %4 vezes, e o último filme desvia no corpo tantas vezes mais que na água</translation>
    </message>
    <message>
        <source>Writing who paints what</source>
        <translation>Gravando quem pinta o quê</translation>
    </message>
    <message>
        <source>Writing the tolerances of %1</source>
        <translation>Gravando as tolerâncias de %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The body reaches past the edge of the tank “%1”; move or turn it</source>
        <translation>O corpo ultrapassa a borda do tanque “%1”; mova-o ou gire-o</translation>
    </message>
    <message>
        <source>The body reaches past the film&apos;s edge; move or turn it, or %1</source>
        <translation>O corpo ultrapassa a borda do filme; mova-o ou gire-o, ou %1</translation>
    </message>
    <message>
        <source>Film %1: %2 × %3 mm, pieces: %4, %5 % of it used</source>
        <translation>Filme %1: %2 × %3 mm, peças: %4, %5 % usado</translation>
    </message>
    <message>
        <source>Writing film %1</source>
        <translation>Gravando o filme %1</translation>
    </message>
    <message>
        <source>Dipping deeper</source>
        <translation>Mergulhando mais fundo</translation>
    </message>
    <message>
        <source>Two plates of the sheet are called %1; give each a name of its own</source>
        <translation>Duas chapas da folha se chamam %1; dê a cada uma um nome próprio</translation>
    </message>
    <message>
        <source>The artwork has %1 spot inks, and there is room for %2</source>
        <translation>A arte tem %1 tintas especiais, e há lugar para %2</translation>
    </message>
    <message>
        <source>Of the model&apos;s file: %1</source>
        <translation>Do arquivo do modelo: %1</translation>
    </message>
    <message>
        <source>Parts of the model are only %1 mm thick, and the distance field, with cells of %2 mm, is at its limit: film may miss them; make them thicker, or dip a smaller part of the model</source>
        <translation>Partes do modelo têm só %1 mm de espessura, e o campo de distância, com células de %2 mm, está no seu limite: o filme pode não as encontrar; torne-as mais espessas ou mergulhe uma parte menor do modelo</translation>
    </message>
    <message>
        <source>The model is inside out, at least in parts, and film does not lie on what faces inwards; import it anew, which turns it</source>
        <translation>O modelo está virado do avesso, pelo menos em partes, e o filme não se deposita no que está voltado para dentro; importe-o de novo, o que o desvira</translation>
    </message>
    <message>
        <source>The sheets take about %1 GB of memory while they are made</source>
        <translation>As folhas ocupam cerca de %1 GB de memória enquanto são feitas</translation>
    </message>
    <message>
        <source>The sheets would take about %1 GB of memory, and this computer has %2 GB: choose a lower resolution or a smaller film</source>
        <translation>As folhas ocupariam cerca de %1 GB de memória, e este computador tem %2 GB: escolha uma resolução menor ou um filme menor</translation>
    </message>
    <message>
        <source>The picture on the film</source>
        <translation>A imagem no filme</translation>
    </message>
</context>
<context>
    <name>PlainFile</name>
    <message>
        <source>it is a folder</source>
        <translation>é uma pasta</translation>
    </message>
    <message>
        <source>it is a pipe or a device; save what it sends as a file, and name that</source>
        <translation>é um pipe ou um dispositivo; salve o que ele envia como arquivo e indique esse arquivo</translation>
    </message>
</context>
<context>
    <name>Png</name>
    <message>
        <source>The picture cannot be stored as PNG: %1</source>
        <translation>A imagem não pode ser guardada como PNG: %1</translation>
    </message>
    <message>
        <source>The picture cannot be stored as PNG, it is empty or too large for this computer&apos;s memory</source>
        <translation>A imagem não pode ser guardada como PNG, está vazia ou é grande demais para a memória deste computador</translation>
    </message>
</context>
<context>
    <name>PoseSearch</name>
    <message>
        <source>Trying poses</source>
        <translation>Testando posições</translation>
    </message>
    <message>
        <source>No pose paints anything; choose a larger film</source>
        <translation>Nenhuma posição pinta algo; escolha um filme maior</translation>
    </message>
    <message>
        <source>Immersion %1</source>
        <translation>Imersão %1</translation>
    </message>
    <message>
        <source>The project has no model, import one first</source>
        <translation>O projeto não tem modelo; importe um primeiro</translation>
    </message>
    <message>
        <source>Judging directions by the body&apos;s shape</source>
        <translation>Avaliando direções pela forma do corpo</translation>
    </message>
    <message>
        <source>part %1 of %2</source>
        <translation>parte %1 de %2</translation>
    </message>
    <message>
        <source>Hand over each of the %1 parts once; there are %2</source>
        <translation>Entregue cada uma das %1 partes uma vez; há %2</translation>
    </message>
    <message>
        <source>This part does not hold the dips that are its share; make it again</source>
        <translation>Esta parte não contém as imersões que lhe cabem; faça-a de novo</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>o mesmo</translation>
    </message>
    <message>
        <source>This is not a part of a pose search, or it is damaged; make it again</source>
        <translation>Isto não é uma parte de uma busca de poses ou está danificado; faça-o de novo</translation>
    </message>
    <message>
        <source>Choose a number from %1 to %2</source>
        <translation>Escolha um número de %1 a %2</translation>
    </message>
    <message>
        <source>There is no measure of this name; choose one of %1</source>
        <translation>Não há medida com este nome; escolha uma de %1</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualidade</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Cobertura</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Maior estiramento</translation>
    </message>
    <message>
        <source>Certain</source>
        <translation>Certo</translation>
    </message>
    <message>
        <source>Wrinkled</source>
        <translation>Enrugado</translation>
    </message>
    <message>
        <source>Torn</source>
        <translation>Rasgado</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Ar preso</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Emenda</translation>
    </message>
    <message>
        <source>Film used</source>
        <translation>Filme usado</translation>
    </message>
    <message>
        <source>weight of a zone</source>
        <translation>peso de uma zona</translation>
    </message>
    <message>
        <source>All weights are 0; give one of them more</source>
        <translation>Todos os pesos são 0; dê mais a um deles</translation>
    </message>
    <message>
        <source>This part belongs to another search; make all parts from the same project with the same options and solver</source>
        <translation>Esta parte é de outra busca; faça todas as partes do mesmo projeto com as mesmas opções e o mesmo solucionador</translation>
    </message>
    <message>
        <source>Narrow overlap</source>
        <translation>Sobreposição estreita</translation>
    </message>
</context>
<context>
    <name>ProfileSpecs</name>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>What the profile is called in lists and in projects.</source>
        <translation>Como o perfil se chama em listas e projetos.</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Livre</translation>
    </message>
    <message>
        <source>Held by a barrier</source>
        <translation>Preso por uma barreira</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Direita</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Em cima</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Embaixo</translation>
    </message>
    <message>
        <source>System&apos;s name</source>
        <translation>Nome no sistema</translation>
    </message>
    <message>
        <source>The name under which the system knows the printer. It is then chosen at first when a sheet is printed.</source>
        <translation>O nome com que o sistema conhece a impressora. Ela já vem escolhida quando se imprime uma folha.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Printed length over true length, across the paper and along its feed. Sheets are drawn smaller by it. “Calibrate Printer” measures it.</source>
        <translation>Comprimento impresso dividido pelo real, na largura do papel e no sentido do avanço. As folhas são desenhadas menores nessa proporção. “Calibrar impressora” mede isso.</translation>
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
        <source>Margins</source>
        <translation>Margens</translation>
    </message>
    <message>
        <source>What the printer does not reach at the paper&apos;s left, top, right and bottom edge.</source>
        <translation>O que a impressora não alcança nas bordas esquerda, superior, direita e inferior do papel.</translation>
    </message>
    <message>
        <source>L</source>
        <comment>left</comment>
        <translation>E</translation>
    </message>
    <message>
        <source>T</source>
        <comment>top</comment>
        <translation>S</translation>
    </message>
    <message>
        <source>R</source>
        <comment>right</comment>
        <translation>D</translation>
    </message>
    <message>
        <source>B</source>
        <comment>bottom</comment>
        <translation>I</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolução</translation>
    </message>
    <message>
        <source>Pixels an inch of the sheets for this printer.</source>
        <translation>Pixels por polegada das folhas para esta impressora.</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Cor</translation>
    </message>
    <message>
        <source>Rendering intent</source>
        <translation>Intenção de renderização</translation>
    </message>
    <message>
        <source>How colours that the printer cannot make are brought into its reach.</source>
        <translation>Como as cores que a impressora não consegue fazer são trazidas para o seu alcance.</translation>
    </message>
    <message>
        <source>Perceptual</source>
        <translation>Perceptual</translation>
    </message>
    <message>
        <source>Relative colorimetric</source>
        <translation>Colorimétrico relativo</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Saturação</translation>
    </message>
    <message>
        <source>Absolute colorimetric</source>
        <translation>Colorimétrico absoluto</translation>
    </message>
    <message>
        <source>Fit black point</source>
        <translation>Ajustar ponto preto</translation>
    </message>
    <message>
        <source>Fits the darkest dark to what the printer can print, so that shadows stay distinct.</source>
        <translation>Ajusta o tom mais escuro ao que a impressora consegue, para que as sombras continuem distintas.</translation>
    </message>
    <message>
        <source>Ink limit</source>
        <translation>Limite de tinta</translation>
    </message>
    <message>
        <source>The highest optical density a channel that the film holds.</source>
        <translation>A maior densidade óptica por canal que o filme suporta.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>Width and height of the dry film.</source>
        <translation>Largura e altura do filme seco.</translation>
    </message>
    <message>
        <source>W</source>
        <comment>width</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>H</source>
        <comment>height</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Alimentação</translation>
    </message>
    <message>
        <source>The edge that goes into the printer first: a film swells more along its web.</source>
        <translation>A borda que entra primeiro na impressora: um filme incha mais ao longo da bobina.</translation>
    </message>
    <message>
        <source>Short edge first</source>
        <translation>Borda curta primeiro</translation>
    </message>
    <message>
        <source>Long edge first</source>
        <translation>Borda longa primeiro</translation>
    </message>
    <message>
        <source>Lot</source>
        <translation>Lote</translation>
    </message>
    <message>
        <source>The maker&apos;s number: another lot may swell otherwise.</source>
        <translation>O número do fabricante: outro lote pode inchar de outro modo.</translation>
    </message>
    <message>
        <source>Use before</source>
        <translation>Usar até</translation>
    </message>
    <message>
        <source>A date such as 2027-03-31, or nothing.</source>
        <translation>Uma data como 2027-03-31, ou nada.</translation>
    </message>
    <message>
        <source>Behaviour on the water</source>
        <translation>Comportamento na água</translation>
    </message>
    <message>
        <source>Soak time</source>
        <translation>Tempo de molho</translation>
    </message>
    <message>
        <source>From the water to the activator.</source>
        <translation>Da água até o ativador.</translation>
    </message>
    <message>
        <source>Activator time</source>
        <translation>Tempo do ativador</translation>
    </message>
    <message>
        <source>From the activator to the dip.</source>
        <translation>Do ativador até a imersão.</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Lados</translation>
    </message>
    <message>
        <source>Width and length of the water.</source>
        <translation>Largura e comprimento da água.</translation>
    </message>
    <message>
        <source>L</source>
        <comment>length</comment>
        <translation>C</translation>
    </message>
    <message>
        <source>Water level</source>
        <translation>Nível da água</translation>
    </message>
    <message>
        <source>How far the water stands under the tank&apos;s rim.</source>
        <translation>A que distância da borda do tanque fica a água.</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marcas</translation>
    </message>
    <message>
        <source>Between the tank&apos;s marks, across and along, which the sheet&apos;s registration marks are laid to. 0: there are none.</source>
        <translation>Distância entre as marcas do tanque, na largura e no comprimento, às quais se alinham as marcas de registro da folha. 0: não há.</translation>
    </message>
    <message>
        <source>Barriers</source>
        <translation>Barreiras</translation>
    </message>
    <message>
        <source>Whether a barrier in the tank holds this side of the film.</source>
        <translation>Se uma barreira no tanque prende este lado do filme.</translation>
    </message>
    <message>
        <source>Advanced: laws without measurement</source>
        <translation>Avançado: leis sem medição</translation>
    </message>
    <message>
        <source>Flash time</source>
        <translation>Tempo de evaporação</translation>
    </message>
    <message>
        <source>From the dip to the rinse.</source>
        <translation>Do mergulho ao enxágue.</translation>
    </message>
    <message>
        <source>Not given</source>
        <translation>Não informado</translation>
    </message>
    <message>
        <source>Drying time</source>
        <translation>Tempo de secagem</translation>
    </message>
    <message>
        <source>From the rinse until the body may be touched, or dipped again.</source>
        <translation>Do enxágue até o corpo poder ser tocado ou mergulhado de novo.</translation>
    </message>
    <message>
        <source>Measured by photos</source>
        <translation>Medido por fotos</translation>
    </message>
    <message>
        <source>Measured on</source>
        <translation>Medido em</translation>
    </message>
    <message>
        <source>The day of the photos. While swell and growth are what they gave, the profile counts as measured, else as guessed.</source>
        <translation>O dia das fotos. Enquanto inchamento e crescimento forem os que elas deram, o perfil conta como medido; senão, como suposto.</translation>
    </message>
    <message>
        <source>Water, °C</source>
        <translation>Água, °C</translation>
    </message>
    <message>
        <source>How warm the water was.</source>
        <translation>Quão quente estava a água.</translation>
    </message>
    <message>
        <source>Swell found</source>
        <translation>Inchamento encontrado</translation>
    </message>
    <message>
        <source>The swell that the photos gave. 0: none.</source>
        <translation>O inchamento que as fotos deram. 0: nenhum.</translation>
    </message>
    <message>
        <source>… and off by</source>
        <translation>… com erro de</translation>
    </message>
    <message>
        <source>How far that swell may be off, at 95 %.</source>
        <translation>Quanto esse inchamento pode errar, a 95 %.</translation>
    </message>
    <message>
        <source>Growth found</source>
        <translation>Crescimento encontrado</translation>
    </message>
    <message>
        <source>The growth that the photos gave.</source>
        <translation>O crescimento que as fotos deram.</translation>
    </message>
    <message>
        <source>… at most</source>
        <translation>… no máximo</translation>
    </message>
    <message>
        <source>The growth&apos;s limit that the photos gave.</source>
        <translation>O limite do crescimento que as fotos deram.</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Resíduo</translation>
    </message>
    <message>
        <source>How far the corners in the photos lie from where these figures have them, on the average.</source>
        <translation>A que distância, em média, os cantos nas fotos ficam de onde estes números os põem.</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>The SHA-256 of the photos&apos; files, by which they can be known again.</source>
        <translation>O SHA-256 dos arquivos das fotos, pelo qual podem ser reconhecidas.</translation>
    </message>
    <message>
        <source>Relaxation found</source>
        <translation>Relaxação encontrada</translation>
    </message>
    <message>
        <source>The relaxation time that photos of a dipped part gave.</source>
        <translation>O tempo de relaxação que fotos de uma peça imersa deram.</translation>
    </message>
    <message>
        <source>Total ink</source>
        <translation>Total de tinta</translation>
    </message>
    <message>
        <source>Most of all four inks together on one place, with an ICC profile in CMYK. Cyan, magenta and yellow give way, black stays.</source>
        <translation>No máximo isto das quatro tintas juntas em um lugar, com um perfil ICC em CMYK. Ciano, magenta e amarelo cedem, o preto fica.</translation>
    </message>
    <message>
        <source>As the ICC profile has it</source>
        <translation>Como no perfil ICC</translation>
    </message>
</context>
<context>
    <name>Profiles</name>
    <message>
        <source>%1, lot %2,</source>
        <translation>%1, lote %2,</translation>
    </message>
    <message>
        <source>The film %1 expired on %2; take a fresh lot, or try this one first</source>
        <translation>O filme %1 venceu em %2; use um lote novo ou teste este antes</translation>
    </message>
    <message>
        <source>The ICC profile is not stored as base64 text, import it anew</source>
        <translation>O perfil ICC não está guardado como texto base64; importe-o de novo</translation>
    </message>
    <message>
        <source>%1 is not a date, write it as 2027-03-31</source>
        <translation>%1 não é uma data; escreva como 2027-03-31</translation>
    </message>
    <message>
        <source>This is not a Dipwright profile</source>
        <translation>Isto não é um perfil do Dipwright</translation>
    </message>
    <message>
        <source>The profile has version %1 of the file format and this program reads up to version %2, open it with a newer Dipwright</source>
        <translation>O perfil tem a versão %1 do formato e este programa lê até a versão %2; abra-o com um Dipwright mais novo</translation>
    </message>
    <message>
        <source>A profile needs a name</source>
        <translation>Um perfil precisa de um nome</translation>
    </message>
    <message>
        <source>There is no %1 profile of this name, there are: %2</source>
        <translation>Não há perfil de %1 com este nome; existem: %2</translation>
    </message>
    <message>
        <source>The folder for profiles cannot be made, choose another with DIPWRIGHT_PROFILE_PATH</source>
        <translation>A pasta de perfis não pode ser criada; escolha outra com DIPWRIGHT_PROFILE_PATH</translation>
    </message>
    <message>
        <source>The profile cannot be removed</source>
        <translation>O perfil não pode ser removido</translation>
    </message>
    <message>
        <source>There is no %1 profile of your own of this name</source>
        <translation>Não há perfil seu de %1 com este nome</translation>
    </message>
    <message>
        <source>This is not a Dipwright profile: %1</source>
        <translation>Isto não é um perfil do Dipwright: %1</translation>
    </message>
    <message>
        <source>The profile cannot be written: %1</source>
        <translation>O perfil não pode ser gravado: %1</translation>
    </message>
    <message>
        <source>There is no such kind of profile, use printer, film or tank</source>
        <translation>Não há esse tipo de perfil; use printer, film ou tank</translation>
    </message>
    <message>
        <source>There is no such value in this profile, there are %1</source>
        <translation>Não há esse valor neste perfil; existem %1</translation>
    </message>
    <message>
        <source>The profile is being written elsewhere (%1), try again</source>
        <translation>O perfil está sendo gravado em outro lugar (%1); tente de novo</translation>
    </message>
    <message>
        <source>Another program has changed the profile since it was read, nothing is saved; look at what it says now and do it again</source>
        <translation>Outro programa mudou o perfil desde que foi lido; nada foi salvo. Veja o que ele diz agora e faça de novo</translation>
    </message>
    <message>
        <source>The file that is there cannot be read as a profile and is not replaced; mend it, move it away, or choose another name: %1</source>
        <translation>O arquivo existente não pode ser lido como perfil e não é substituído; corrija-o, mova-o ou escolha outro nome: %1</translation>
    </message>
</context>
<context>
    <name>Project</name>
    <message>
        <source>a text of at most %1 characters</source>
        <translation>um texto de no máximo %1 caracteres</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>um de %1</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>um número de %1 a %2</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>um número inteiro de %1 a %2</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>uma lista</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>um objeto</translation>
    </message>
    <message>
        <source>%1 does not fit here, give %2</source>
        <translation>%1 não serve aqui; informe %2</translation>
    </message>
    <message>
        <source>%1 does not fit here, give %2 parts, each %3</source>
        <translation>%1 não serve aqui; informe %2 partes, cada uma %3</translation>
    </message>
    <message>
        <source>“%1” must be an object</source>
        <translation>“%1” deve ser um objeto</translation>
    </message>
    <message>
        <source>There is no film size of this name, use one of %1</source>
        <translation>Não há tamanho de filme com este nome; use um de %1</translation>
    </message>
    <message>
        <source>immersions must be an array of one or two immersions</source>
        <translation>immersions deve ser uma lista de uma ou duas imersões</translation>
    </message>
    <message>
        <source>%1 must be an object</source>
        <translation>%1 deve ser um objeto</translation>
    </message>
    <message>
        <source>profiles.%1 holds a profile of another kind</source>
        <translation>profiles.%1 contém um perfil de outro tipo</translation>
    </message>
    <message>
        <source>This is not a Dipwright project</source>
        <translation>Isto não é um projeto do Dipwright</translation>
    </message>
    <message>
        <source>The project has version %1 of the file format and this program reads up to version %2, open it with a newer Dipwright</source>
        <translation>O projeto tem a versão %1 do formato e este programa lê até a versão %2; abra-o com um Dipwright mais novo</translation>
    </message>
    <message>
        <source>there are %1</source>
        <translation>existem %1</translation>
    </message>
    <message>
        <source>There is no such setting, %1</source>
        <translation>Essa configuração não existe; %1</translation>
    </message>
    <message>
        <source>There is no preset %1, use production or paper-2020</source>
        <translation>Não há predefinição %1; use production ou paper-2020</translation>
    </message>
    <message>
        <source>%1 × %2 points are more than the %3 million that a film may have, give fewer</source>
        <translation>%1 × %2 pontos passam dos %3 milhões que um filme pode ter; use menos</translation>
    </message>
    <message>
        <source>A value is missing, give %1</source>
        <translation>Falta um valor, informe %1</translation>
    </message>
    <message>
        <source>%1 must be an array of at most %2 entries</source>
        <translation>%1 deve ser uma lista de no máximo %2 itens</translation>
    </message>
    <message>
        <source>inspection.pairs names a photo that inspection.photos has not</source>
        <translation>inspection.pairs nomeia uma foto que inspection.photos não tem</translation>
    </message>
    <message>
        <source>A spot ink needs a name of its own, and not All, None, or that of one of the four inks</source>
        <translation>Uma tinta especial precisa de um nome próprio, que não seja All, None nem o de uma das quatro tintas</translation>
    </message>
    <message>
        <source>“%1” is not a colour, write it as #1a2b3c</source>
        <translation>“%1” não é uma cor, escreva como #1a2b3c</translation>
    </message>
    <message>
        <source>a colour such as #1a2b3c</source>
        <translation>uma cor como #1a2b3c</translation>
    </message>
    <message>
        <source>The artwork&apos;s layers are %1 in number, the lowest is artwork.layers[0]</source>
        <translation>As camadas da arte são %1, a mais baixa é artwork.layers[0]</translation>
    </message>
    <message>
        <source>The project&apos;s immersions are %1 in number, the first is immersions[0]</source>
        <translation>As imersões do projeto são %1, a primeira é immersions[0]</translation>
    </message>
    <message>
        <source>the sections are artwork, film, process, body, immersions[0], sheet, ink, share, cradle, tolerance, pose_search, as_built and inspection</source>
        <translation>as seções são artwork, film, process, body, immersions[0], sheet, ink, share, cradle, tolerance, pose_search, as_built e inspection</translation>
    </message>
</context>
<context>
    <name>ProjectDifferences</name>
    <message>
        <source>Yes</source>
        <translation>Sim</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Não</translation>
    </message>
    <message>
        <source>Immersions</source>
        <translation>Imersões</translation>
    </message>
    <message>
        <source>Marks for the join</source>
        <translation>Marcas para a junção</translation>
    </message>
    <message>
        <source>Marks for zones</source>
        <translation>Marcas para zonas</translation>
    </message>
    <message>
        <source>Printer&apos;s profile</source>
        <translation>Perfil da impressora</translation>
    </message>
    <message>
        <source>Film&apos;s profile</source>
        <translation>Perfil do filme</translation>
    </message>
    <message>
        <source>Tank&apos;s profile</source>
        <translation>Perfil do tanque</translation>
    </message>
    <message>
        <source>Pose search · weight of %1</source>
        <translation>Busca de poses · peso de %1</translation>
    </message>
    <message>
        <source>Pose search · limit of %1</source>
        <translation>Busca de poses · limite de %1</translation>
    </message>
    <message>
        <source>Pose search · weight of zone %1</source>
        <translation>Busca de poses · peso da zona %1</translation>
    </message>
    <message>
        <source>Artwork · base colour</source>
        <translation>Arte · cor de base</translation>
    </message>
    <message>
        <source>%1, otherwise</source>
        <translation>%1, no mais diferente</translation>
    </message>
    <message>
        <source>Artwork · layer %1</source>
        <translation>Arte · camada %1</translation>
    </message>
    <message>
        <source>%1, %2 × %3%7 at (%4; %5; %6)%7, turned by %8°</source>
        <translation>%1, %2 × %3%7 em (%4; %5; %6)%7, girada em %8°</translation>
    </message>
</context>
<context>
    <name>ProjectFile</name>
    <message>
        <source>Another program has written the project since it was read, nothing is saved; look at what it holds now and do it again</source>
        <translation>Outro programa gravou o projeto desde que foi lido; nada foi salvo. Veja o que ele contém agora e faça de novo</translation>
    </message>
    <message>
        <source>The project is open elsewhere (%1); close it there, or work on a copy</source>
        <translation>O projeto está aberto em outro lugar (%1); feche-o lá ou trabalhe em uma cópia</translation>
    </message>
    <message>
        <source>The file that is there cannot be read, and nothing is saved over it; try again, or save under another name</source>
        <translation>O arquivo que está ali não pode ser lido, e nada é salvo por cima dele; tente de novo ou salve com outro nome</translation>
    </message>
</context>
<context>
    <name>ProjectStore</name>
    <message>
        <source>This is not a Dipwright project, it holds no project.json</source>
        <translation>Isto não é um projeto do Dipwright; não contém project.json</translation>
    </message>
    <message>
        <source>project.json is damaged at character %1: %2</source>
        <translation>project.json está danificado no caractere %1: %2</translation>
    </message>
    <message>
        <source>The model in the project is not the one that was saved, its sha256 differs</source>
        <translation>O modelo no projeto não é o que foi salvo; seu sha256 difere</translation>
    </message>
    <message>
        <source>The project lists %1 textures and its model needs %2</source>
        <translation>O projeto lista %1 texturas e seu modelo precisa de %2</translation>
    </message>
    <message>
        <source>The project cannot be saved: %1</source>
        <translation>O projeto não pode ser salvo: %1</translation>
    </message>
    <message>
        <source>project.json holds a list where a project should be</source>
        <translation>project.json contém uma lista onde deveria haver um projeto</translation>
    </message>
    <message>
        <source>The project names no model, model.mesh is missing</source>
        <translation>O projeto não nomeia nenhum modelo, falta model.mesh</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 em %2</translation>
    </message>
    <message>
        <source>The project is not saved, as it could not be opened again: %1</source>
        <translation>O projeto não é salvo, pois não poderia ser aberto de novo: %1</translation>
    </message>
</context>
<context>
    <name>ProjectValue</name>
    <message>
        <source>There is no such setting</source>
        <translation>Essa configuração não existe</translation>
    </message>
</context>
<context>
    <name>PropertySpecs</name>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>What the project is called. It stands in the job line of every sheet.</source>
        <translation>Como o projeto se chama. O nome aparece na linha de trabalho de cada folha.</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>The date in the job line. It belongs to the project, so that the same project always gives the same sheet.</source>
        <translation>A data na linha de trabalho. Ela pertence ao projeto, para que o mesmo projeto dê sempre a mesma folha.</translation>
    </message>
    <message>
        <source>Distance field</source>
        <translation>Campo de distância</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolução</translation>
    </message>
    <message>
        <source>Samples along each edge of the cube round the body in which the distance to its surface is kept. More follows finer detail and takes longer to build.</source>
        <translation>Amostras em cada aresta do cubo em volta do corpo, no qual fica a distância à superfície. Mais amostras seguem detalhes mais finos e demoram mais.</translation>
    </message>
    <message>
        <source>Printed film</source>
        <translation>Filme impresso</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>The size in which the film comes and is printed.</source>
        <translation>O tamanho em que o filme vem e é impresso.</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizado</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>Width and height of the printed film. The grid keeps its spacing.</source>
        <translation>Largura e altura do filme impresso. A grade mantém o espaçamento.</translation>
    </message>
    <message>
        <source>W</source>
        <comment>width</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>H</source>
        <comment>height</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Pontos</translation>
    </message>
    <message>
        <source>Points of the simulated film across and down. More points show finer detail and take longer.</source>
        <translation>Pontos do filme simulado na largura e na altura. Mais pontos mostram mais detalhe e demoram mais.</translation>
    </message>
    <message>
        <source>Behaviour on the water</source>
        <translation>Comportamento na água</translation>
    </message>
    <message>
        <source>Swell</source>
        <translation>Inchamento</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxação</translation>
    </message>
    <message>
        <source>Film model</source>
        <translation>Modelo do filme</translation>
    </message>
    <message>
        <source>Isotropic film resists shear and gives the same result whichever way the grid lies. The structural lattice joins horizontal and vertical neighbours only, as in the paper of 2020.</source>
        <translation>O filme isotrópico resiste ao cisalhamento e dá o mesmo resultado em qualquer orientação da grade. A rede estrutural une só vizinhos horizontais e verticais, como no artigo de 2020.</translation>
    </message>
    <message>
        <source>Isotropic</source>
        <translation>Isotrópico</translation>
    </message>
    <message>
        <source>Structural lattice</source>
        <translation>Rede estrutural</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Apoio</translation>
    </message>
    <message>
        <source>Whether the water holds up the free film. Without it nothing does.</source>
        <translation>Se a água sustenta o filme livre. Sem ela, nada o sustenta.</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Água</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nenhum</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Lados</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimento</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidade</translation>
    </message>
    <message>
        <source>How fast the body comes down into the water.</source>
        <translation>Com que velocidade o corpo desce na água.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidade</translation>
    </message>
    <message>
        <source>How far the lowest point of the body goes under the waterline. “Whole body” dips until all of it is under.</source>
        <translation>Quanto o ponto mais baixo do corpo desce abaixo da linha d&apos;água. “Corpo inteiro” mergulha até tudo ficar submerso.</translation>
    </message>
    <message>
        <source>Whole body</source>
        <translation>Corpo inteiro</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margem</translation>
    </message>
    <message>
        <source>How much farther than fully under the body is dipped.</source>
        <translation>Quanto além de totalmente submerso o corpo é mergulhado.</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Precisão</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>How far the contact line travels in one step, in cells of the film. Smaller is finer and slower.</source>
        <translation>Quanto a linha de contato avança em um passo, em células do filme. Menor é mais fino e mais lento.</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Passo de tempo</translation>
    </message>
    <message>
        <source>Time that one step simulates.</source>
        <translation>Tempo que um passo simula.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterações</translation>
    </message>
    <message>
        <source>Sweeps over all constraints in one step.</source>
        <translation>Passagens por todas as restrições em um passo.</translation>
    </message>
    <message>
        <source>Sweeps</source>
        <translation>Passagens</translation>
    </message>
    <message>
        <source>Jacobi corrects all points at once and averages; Gauss–Seidel one after the other.</source>
        <translation>Jacobi corrige todos os pontos de uma vez e tira a média; Gauss–Seidel, um após o outro.</translation>
    </message>
    <message>
        <source>Self-contact</source>
        <translation>Autocontato</translation>
    </message>
    <message>
        <source>Keep film from passing through film.</source>
        <translation>Impede que o filme atravesse o filme.</translation>
    </message>
    <message>
        <source>What this immersion is called. It stands in the job line of its sheet.</source>
        <translation>Como esta imersão se chama. O nome aparece na linha de trabalho da folha.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotação</translation>
    </message>
    <message>
        <source>How the body is turned about X, then Y, then Z before it is dipped. Drag the rings in the view to turn it by hand; hold Shift for steps of 15°.</source>
        <translation>Como o corpo é girado em X, depois Y, depois Z antes de mergulhar. Arraste os anéis na vista para girá-lo à mão; segure Shift para passos de 15°.</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Deslocamento</translation>
    </message>
    <message>
        <source>Where the body meets the film, from the middle of the film: X to the right, Z down the sheet.</source>
        <translation>Onde o corpo encontra o filme, a partir do meio do filme: X para a direita, Z para baixo na folha.</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>The page that the film image is laid on. “As the film” prints the film itself, edge to edge.</source>
        <translation>A página em que a imagem do filme é posta. “Como o filme” imprime o próprio filme, de borda a borda.</translation>
    </message>
    <message>
        <source>As the film</source>
        <translation>Como o filme</translation>
    </message>
    <message>
        <source>Width and height of the page.</source>
        <translation>Largura e altura da página.</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Paisagem</translation>
    </message>
    <message>
        <source>Turn the page on its side.</source>
        <translation>Vira a página de lado.</translation>
    </message>
    <message>
        <source>Pixels to the inch of the film image.</source>
        <translation>Pixels por polegada da imagem do filme.</translation>
    </message>
    <message>
        <source>Bleed</source>
        <translation>Sangria</translation>
    </message>
    <message>
        <source>How far the colour is continued past the painted area, so that a small error of position leaves no bare edge.</source>
        <translation>Quanto a cor continua além da área pintada, para que um pequeno erro de posição não deixe borda nua.</translation>
    </message>
    <message>
        <source>On the page</source>
        <translation>Na página</translation>
    </message>
    <message>
        <source>Registration marks</source>
        <translation>Marcas de registro</translation>
    </message>
    <message>
        <source>Marks in the corners by which the film is laid into the tank.</source>
        <translation>Marcas nos cantos para posicionar o filme no tanque.</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Régua</translation>
    </message>
    <message>
        <source>A ruler of 100 mm: measure it to see that the page was printed at true size.</source>
        <translation>Uma régua de 100 mm: meça-a para ver se a página saiu em tamanho real.</translation>
    </message>
    <message>
        <source>Job line</source>
        <translation>Linha de trabalho</translation>
    </message>
    <message>
        <source>A line with project, immersion, date, film, scale and a check sum.</source>
        <translation>Uma linha com projeto, imersão, data, filme, escala e soma de verificação.</translation>
    </message>
    <message>
        <source>Compensate stretch</source>
        <translation>Compensar estiramento</translation>
    </message>
    <message>
        <source>Ink thins where the film stretches. Print more there, so that the body shows the colour of the texture.</source>
        <translation>A tinta afina onde o filme estica. Imprime mais ali, para que o corpo mostre a cor da textura.</translation>
    </message>
    <message>
        <source>Ink limit</source>
        <translation>Limite de tinta</translation>
    </message>
    <message>
        <source>The highest optical density that can be printed. Where more would be needed, the colour falls short and the report says so.</source>
        <translation>A maior densidade óptica que pode ser impressa. Onde seria preciso mais, a cor fica aquém e o relatório avisa.</translation>
    </message>
    <message>
        <source>Advanced: laws without measurement</source>
        <translation>Avançado: leis sem medição</translation>
    </message>
    <message>
        <source>How fine the simulated film is. Automatic chooses the size of its cells from the body&apos;s narrow parts and its pose: fine where the body comes down, coarse towards the film&apos;s edges.</source>
        <translation>Quão fino é o filme simulado. “Automática” escolhe o tamanho das células segundo as partes estreitas do corpo e a sua posição: finas onde o corpo desce, grossas em direção às bordas do filme.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automática</translation>
    </message>
    <message>
        <source>Size of the cells</source>
        <translation>Tamanho das células</translation>
    </message>
    <message>
        <source>Number of points</source>
        <translation>Número de pontos</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Células</translation>
    </message>
    <message>
        <source>The side of the simulated film&apos;s cells where the body comes down. Smaller cells show finer detail and take longer.</source>
        <translation>O lado das células do filme simulado onde o corpo desce. Células menores mostram detalhes mais finos e demoram mais.</translation>
    </message>
    <message>
        <source>Each dip paints the places that it paints better, and leaves the others blank. If not, both paint all that they reach, and some places are painted twice.</source>
        <translation>Cada imersão pinta os lugares que pinta melhor e deixa os outros em branco. Senão, ambas pintam tudo o que alcançam, e alguns lugares são pintados duas vezes.</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Sobreposição</translation>
    </message>
    <message>
        <source>The band along the join in which both dips fade into each other, on the body. It is made wider where the registration error would show in it.</source>
        <translation>A faixa ao longo da junção em que as duas imersões se fundem, no corpo. Ela fica mais larga onde o erro de registro apareceria.</translation>
    </message>
    <message>
        <source>Registration error</source>
        <translation>Erro de registro</translation>
    </message>
    <message>
        <source>How far the second dip may lie off the first. The band is made wide enough that no edge shows.</source>
        <translation>Quanto a segunda imersão pode desviar da primeira. A faixa fica larga o bastante para que nenhuma borda apareça.</translation>
    </message>
    <message>
        <source>Stretched by at most</source>
        <translation>Esticado no máximo</translation>
    </message>
    <message>
        <source>Where one dip&apos;s film is drawn out to more times its length, the other is to paint, if it can.</source>
        <translation>Onde o filme de uma imersão é esticado além de tantas vezes o seu comprimento, a outra pinta, se puder.</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>Berço</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Folga</translation>
    </message>
    <message>
        <source>How far the cradle keeps off the body that lies in it.</source>
        <translation>Quanto o berço se afasta do corpo que está nele.</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Paredes</translation>
    </message>
    <message>
        <source>How thick what holds the body is, at its thinnest.</source>
        <translation>Espessura mínima do que segura o corpo.</translation>
    </message>
    <message>
        <source>Reaches down</source>
        <translation>Desce até</translation>
    </message>
    <message>
        <source>How far below the body&apos;s top the cradle reaches. It goes deeper where the body would tip or slide.</source>
        <translation>Quanto abaixo do topo do corpo o berço alcança. Ele desce mais onde o corpo tombaria ou escorregaria.</translation>
    </message>
    <message>
        <source>Off the film</source>
        <translation>Longe do filme</translation>
    </message>
    <message>
        <source>How far the cradle keeps off all that the film reaches, and off what earlier dips have painted.</source>
        <translation>Quanto o berço se afasta de tudo que o filme alcança e do que mergulhos anteriores pintaram.</translation>
    </message>
    <message>
        <source>On paint</source>
        <translation>Sobre tinta</translation>
    </message>
    <message>
        <source>Whether the cradle may lie on what earlier dips have painted, through padding.</source>
        <translation>Se o berço pode apoiar-se, através de um forro, no que mergulhos anteriores pintaram.</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Forro</translation>
    </message>
    <message>
        <source>Room that is left for felt or foam where the cradle lies on paint.</source>
        <translation>Espaço deixado para feltro ou espuma onde o berço se apoia em tinta.</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Placa</translation>
    </message>
    <message>
        <source>How thick the plate is that the cradle hangs from.</source>
        <translation>Espessura da placa em que o berço está pendurado.</translation>
    </message>
    <message>
        <source>Off the water</source>
        <translation>Acima da água</translation>
    </message>
    <message>
        <source>How far the plate stays above the water at the end of the dip.</source>
        <translation>Quanto a placa fica acima da água no fim do mergulho.</translation>
    </message>
    <message>
        <source>Pins apart</source>
        <translation>Distância dos pinos</translation>
    </message>
    <message>
        <source>How far apart two of the datum pins are at most. They stand where the sheet&apos;s marks float, or are drawn in towards the film&apos;s middle.</source>
        <translation>Distância máxima entre dois dos pinos de referência. Ficam onde as marcas da folha flutuam, ou recuados em direção ao meio do filme.</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Pinos</translation>
    </message>
    <message>
        <source>The diameter of the datum pins of the tank&apos;s frame.</source>
        <translation>Diâmetro dos pinos de referência da armação do tanque.</translation>
    </message>
    <message>
        <source>Pin clearance</source>
        <translation>Folga dos pinos</translation>
    </message>
    <message>
        <source>How much wider than the pins their holes are, all round.</source>
        <translation>Quanto os furos são mais largos que os pinos, em toda a volta.</translation>
    </message>
    <message>
        <source>Bore</source>
        <translation>Furo</translation>
    </message>
    <message>
        <source>A hole through plate and seat, to fix the body by a screw, suction or hot glue. At 0 there is none.</source>
        <translation>Um furo pela placa e pelo assento, para fixar o corpo com parafuso, ventosa ou cola quente. Em 0 não há nenhum.</translation>
    </message>
    <message>
        <source>Engraving</source>
        <translation>Gravação</translation>
    </message>
    <message>
        <source>How deep arrow, number and job are cut into the plate. At 0 they are not.</source>
        <translation>Profundidade com que seta, número e trabalho são gravados na placa. Em 0 não são.</translation>
    </message>
    <message>
        <source>Fineness</source>
        <translation>Finura</translation>
    </message>
    <message>
        <source>The side of the cells that the cradle&apos;s form is computed on. Smaller is smoother, slower and makes larger files.</source>
        <translation>O lado das células em que a forma do berço é calculada. Menor é mais liso, mais lento e gera arquivos maiores.</translation>
    </message>
    <message>
        <source>Body on the water</source>
        <translation>Corpo na água</translation>
    </message>
    <message>
        <source>How far the body may lie off its place when it meets the film. 95 of 100 dips keep a tolerance.</source>
        <translation>Quanto o corpo pode estar fora do lugar ao tocar o filme. 95 de 100 imersões respeitam uma tolerância.</translation>
    </message>
    <message>
        <source>Body turned</source>
        <translation>Corpo girado</translation>
    </message>
    <message>
        <source>How far the body may be turned off its pose, about axes through its middle.</source>
        <translation>Quanto o corpo pode estar girado em relação à sua pose, em torno de eixos pelo seu centro.</translation>
    </message>
    <message>
        <source>Film on the water</source>
        <translation>Filme na água</translation>
    </message>
    <message>
        <source>How far the film may lie off its place when the body meets it.</source>
        <translation>Quanto o filme pode estar fora do lugar quando o corpo o toca.</translation>
    </message>
    <message>
        <source>Film turned</source>
        <translation>Filme girado</translation>
    </message>
    <message>
        <source>How far the film may be turned on the water, about its middle.</source>
        <translation>Quanto o filme pode estar girado na água, em torno do seu centro.</translation>
    </message>
    <message>
        <source>By how much of its length the floating film may be longer or shorter than reckoned.</source>
        <translation>Em que parte do seu comprimento o filme flutuante pode ser mais longo ou mais curto que o calculado.</translation>
    </message>
    <message>
        <source>Water level</source>
        <translation>Nível da água</translation>
    </message>
    <message>
        <source>By how much the body may go under deeper or less deep.</source>
        <translation>Quanto o corpo pode afundar a mais ou a menos.</translation>
    </message>
    <message>
        <source>By how much of its speed the dip may be faster or slower.</source>
        <translation>Em que parte da sua velocidade a imersão pode ser mais rápida ou mais lenta.</translation>
    </message>
    <message>
        <source>By how much of it the film&apos;s relaxation time may be longer or shorter.</source>
        <translation>Em que parte o tempo de relaxamento do filme pode ser mais longo ou mais curto.</translation>
    </message>
    <message>
        <source>Of the zones</source>
        <translation>Das zonas</translation>
    </message>
    <message>
        <source>How far colours may land off their places, to either side. What is not marked on the body is zone C.</source>
        <translation>Quanto as cores podem cair fora do lugar, para os dois lados. O que não está marcado no corpo é zona C.</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Verificação</translation>
    </message>
    <message>
        <source>Dips</source>
        <translation>Imersões</translation>
    </message>
    <message>
        <source>Dips with everything off at once, to see whether what each does by itself can be added up. 0: none.</source>
        <translation>Imersões com tudo desviado ao mesmo tempo, para ver se o efeito de cada desvio pode ser somado. 0: nenhuma.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semente</translation>
    </message>
    <message>
        <source>What is off by how much in them. Another number draws others.</source>
        <translation>O que desvia quanto nelas. Outro número sorteia outras.</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Correção</translation>
    </message>
    <message>
        <source>By what repeats</source>
        <translation>Pelo que se repete</translation>
    </message>
    <message>
        <source>Takes off the sheet what the parts that the job keeps are off again and again.</source>
        <translation>Tira da folha o desvio que se repete nas peças que o trabalho guarda.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensidade</translation>
    </message>
    <message>
        <source>How much of it is taken off.</source>
        <translation>Quanto disso é tirado.</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Filme</translation>
    </message>
    <message>
        <source>Dipping</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Junção</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Folha</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>Tinta</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolerâncias</translation>
    </message>
    <message>
        <source>Spot inks</source>
        <translation>Tintas especiais</translation>
    </message>
    <message>
        <source>Cut line</source>
        <translation>Linha de corte</translation>
    </message>
    <message>
        <source>A line for the cutter, as a spot ink in a PDF in CMYK.</source>
        <translation>Uma linha para a cortadora, como tinta especial em um PDF em CMYK.</translation>
    </message>
    <message>
        <source>Round the ink</source>
        <translation>Em volta da tinta</translation>
    </message>
    <message>
        <source>Along the film&apos;s edge</source>
        <translation>Ao longo da borda do filme</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distância</translation>
    </message>
    <message>
        <source>Of the cut line from the ink.</source>
        <translation>Da linha de corte até a tinta.</translation>
    </message>
    <message>
        <source>Its ink</source>
        <translation>Sua tinta</translation>
    </message>
    <message>
        <source>The name by which the cutter knows the line.</source>
        <translation>O nome pelo qual a cortadora conhece a linha.</translation>
    </message>
    <message>
        <source>Part&apos;s colour</source>
        <translation>Cor da peça</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Branco</translation>
    </message>
    <message>
        <source>A plate of white under all colour. What is printed last touches the part; printed first, it lies on the outside, over the colour. In PDF and TIFF in CMYK.</source>
        <translation>Uma chapa de branco sob toda a cor. O que é impresso por último toca a peça; impresso primeiro, fica por fora, sobre a cor. Em PDF e TIFF em CMYK.</translation>
    </message>
    <message>
        <source>Printed last, under the colour</source>
        <translation>Impresso por último, sob a cor</translation>
    </message>
    <message>
        <source>Printed first, over the colour</source>
        <translation>Impresso primeiro, sobre a cor</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densidade</translation>
    </message>
    <message>
        <source>Share of full tint that the part is to have; more is printed where the film stretches, as far as full tint goes.</source>
        <translation>Parte do tom cheio que a peça deve ter; imprime-se mais onde o filme estica, até o tom cheio.</translation>
    </message>
    <message>
        <source>Choke</source>
        <translation>Recuo</translation>
    </message>
    <message>
        <source>How much smaller than the colour the white is, all round, on the film.</source>
        <translation>Quanto o branco é menor que a cor, em toda a volta, no filme.</translation>
    </message>
    <message>
        <source>Name of white</source>
        <translation>Nome do branco</translation>
    </message>
    <message>
        <source>The name by which the printer knows its white ink.</source>
        <translation>O nome pelo qual a impressora conhece sua tinta branca.</translation>
    </message>
    <message>
        <source>Of the bare part, as #1a2b3c: proof and view show the ink on it. Empty: light grey, and ink as it looks on white.</source>
        <translation>Da peça nua, como #1a2b3c: a prova e a vista mostram a tinta sobre ela. Vazio: cinza-claro, e a tinta como é vista sobre branco.</translation>
    </message>
    <message>
        <source>Bleed past it</source>
        <translation>Sangria além dela</translation>
    </message>
    <message>
        <source>How far beyond the cut line the colours of the painted film&apos;s edge go on, so that a cut that slips shows no bare film.</source>
        <translation>Até onde as cores da borda do filme pintado continuam para além da linha de corte, para que um corte desviado não mostre filme nu.</translation>
    </message>
    <message>
        <source>Print it</source>
        <translation>Pode imprimir</translation>
    </message>
    <message>
        <source>Check first</source>
        <translation>Verificar antes</translation>
    </message>
    <message>
        <source>Do not print</source>
        <translation>Não imprima</translation>
    </message>
    <message>
        <source>Verdict: check first above</source>
        <translation>Veredito: verificar antes acima de</translation>
    </message>
    <message>
        <source>Trapped air</source>
        <translation>Ar preso</translation>
    </message>
    <message>
        <source>The share of the body&apos;s surface that trapped air may keep dry. The verdict is “do not print” above five times a limit.</source>
        <translation>A parte da superfície do corpo que o ar preso pode manter seca. Acima de cinco vezes um limite o veredito é “Não imprima”.</translation>
    </message>
    <message>
        <source>Too pale</source>
        <translation>Claro demais</translation>
    </message>
    <message>
        <source>The share of the painted area that may look too pale, because the film stretches more than the ink can make up for.</source>
        <translation>A parte da área pintada que pode ficar clara demais, porque o filme estica mais do que a tinta consegue compensar.</translation>
    </message>
    <message>
        <source>Torn or released film</source>
        <translation>Filme rasgado ou solto</translation>
    </message>
    <message>
        <source>The share of the painted area on which the film may tear or be pulled off the body.</source>
        <translation>A parte da área pintada em que o filme pode rasgar ou ser arrancado do corpo.</translation>
    </message>
    <message>
        <source>Reached by neither dip</source>
        <translation>Não alcançado por nenhuma imersão</translation>
    </message>
    <message>
        <source>The share of the body&apos;s surface that neither of two dips may reach. A job of one dip has no such limit.</source>
        <translation>A parte da superfície do corpo que nenhuma de duas imersões precisa alcançar. Um trabalho de uma só imersão não tem esse limite.</translation>
    </message>
    <message>
        <source>Narrow overlap</source>
        <translation>Sobreposição estreita</translation>
    </message>
    <message>
        <source>The share of the overlap of two dips that may be too narrow for how far the second film may lie off.</source>
        <translation>A parte da sobreposição de duas imersões que pode ser estreita demais para o desvio possível do segundo filme.</translation>
    </message>
    <message>
        <source>Bare in a zone</source>
        <translation>Sem tinta numa zona</translation>
    </message>
    <message>
        <source>The share of zone A or B, where they are marked, that may stay without paint.</source>
        <translation>A parte da zona A ou B, onde estão marcadas, que pode ficar sem tinta.</translation>
    </message>
    <message>
        <source>Film&apos;s edge</source>
        <translation>Borda do filme</translation>
    </message>
    <message>
        <source>How far the painted film has to stay from the film&apos;s edge, so that it neither curls nor folds.</source>
        <translation>A que distância da borda do filme o filme que pinta tem de ficar, para que não enrole nem dobre.</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Sem imagem</translation>
    </message>
    <message>
        <source>What a model of one plain colour, without artwork, comes to.</source>
        <translation>O que resulta de um modelo de uma só cor, sem arte.</translation>
    </message>
    <message>
        <source>Repaired model</source>
        <translation>Modelo corrigido</translation>
    </message>
    <message>
        <source>What a model comes to that was put right, or lacks something that its file names.</source>
        <translation>O que resulta de um modelo que foi corrigido ou ao qual falta algo que o arquivo nomeia.</translation>
    </message>
    <message>
        <source>Film not measured</source>
        <translation>Filme não medido</translation>
    </message>
    <message>
        <source>What a film comes to whose swell nobody has measured.</source>
        <translation>O que resulta de um filme cujo inchamento ninguém mediu.</translation>
    </message>
    <message>
        <source>Split the body between the dips</source>
        <translation>Dividir o corpo entre as imersões</translation>
    </message>
    <message>
        <source>Expected deviations (±)</source>
        <translation>Desvios esperados (±)</translation>
    </message>
</context>
<context>
    <name>ReportPanel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Body painted</source>
        <translation>Corpo pintado</translation>
    </message>
    <message>
        <source>Film points on the body</source>
        <translation>Pontos do filme no corpo</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Stretch, mean and largest</source>
        <translation>Estiramento, médio e maior</translation>
    </message>
    <message>
        <source>Area stretch, smallest and largest</source>
        <translation>Estiramento de área, menor e maior</translation>
    </message>
    <message>
        <source>Film triangles across texture seams</source>
        <translation>Triângulos do filme sobre costuras da textura</translation>
    </message>
    <message>
        <source>Colour short of ink</source>
        <translation>Cor com tinta insuficiente</translation>
    </message>
    <message>
        <source>Air trapped</source>
        <translation>Ar preso</translation>
    </message>
    <message>
        <source>Simulated in</source>
        <translation>Simulado em</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Passos</translation>
    </message>
    <message>
        <source>Steps without equilibrium</source>
        <translation>Passos sem equilíbrio</translation>
    </message>
    <message>
        <source>Texture read back, mean and 95 %</source>
        <translation>Textura lida de volta, média e 95 %</translation>
    </message>
    <message>
        <source>Of that, by marked film</source>
        <translation>Disso, por filme marcado</translation>
    </message>
    <message>
        <source>Painted by %1 alone</source>
        <translation>Pintado só por %1</translation>
    </message>
    <message>
        <source>In the overlap, by both</source>
        <translation>Na sobreposição, por ambas</translation>
    </message>
    <message>
        <source>Reached by neither</source>
        <translation>Não alcançado por nenhuma</translation>
    </message>
    <message>
        <source>Width of the overlap</source>
        <translation>Largura da sobreposição</translation>
    </message>
    <message>
        <source>Length of the join</source>
        <translation>Comprimento da junção</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Junção</translation>
    </message>
    <message>
        <source>Smaller places not reached</source>
        <translation>Lugares menores não alcançados</translation>
    </message>
    <message>
        <source>Not reached at %1</source>
        <translation>Não alcançado em %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>Overlap that is too narrow for %1 off</source>
        <translation>Sobreposição estreita demais para um desvio de %1</translation>
    </message>
    <message>
        <source>Most of the film stays empty: %1, %2 × %3, is enough.</source>
        <translation>A maior parte do filme fica vazia: %1, %2 × %3, basta.</translation>
    </message>
    <message>
        <source>Take this film</source>
        <translation>Usar este filme</translation>
    </message>
</context>
<context>
    <name>ShippedNames</name>
    <message>
        <source>Ideal film, A3</source>
        <translation>Filme ideal, A3</translation>
    </message>
    <message>
        <source>Ideal film, A4</source>
        <translation>Filme ideal, A4</translation>
    </message>
    <message>
        <source>Soft film, A4, swells by 5 %</source>
        <translation>Filme macio, A4, incha 5 %</translation>
    </message>
    <message>
        <source>Pigment printer, borderless, 600 dpi</source>
        <translation>Impressora de pigmento, sem margens, 600 dpi</translation>
    </message>
    <message>
        <source>Office printer, 5 mm margins</source>
        <translation>Impressora de escritório, margens de 5 mm</translation>
    </message>
    <message>
        <source>True size, sRGB</source>
        <translation>Tamanho real, sRGB</translation>
    </message>
    <message>
        <source>Tank with barriers on all sides</source>
        <translation>Tanque com barreiras em todos os lados</translation>
    </message>
    <message>
        <source>Open tank</source>
        <translation>Tanque aberto</translation>
    </message>
    <message>
        <source>Position-based film on the CPU</source>
        <translation>Filme baseado em posições na CPU</translation>
    </message>
    <message>
        <source>Position-based film on an NVIDIA GPU</source>
        <translation>Filme baseado em posições em GPU NVIDIA</translation>
    </message>
    <message>
        <source>No NVIDIA driver was found on this computer; install one to compute on the GPU.</source>
        <translation>Nenhum driver NVIDIA foi encontrado neste computador; instale um para calcular na GPU.</translation>
    </message>
    <message>
        <source>No NVIDIA GPU was found on this computer.</source>
        <translation>Nenhuma GPU NVIDIA foi encontrada neste computador.</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Esfera</translation>
    </message>
    <message>
        <source>Tetrahedron</source>
        <translation>Tetraedro</translation>
    </message>
    <message>
        <source>Turtle</source>
        <translation>Tartaruga</translation>
    </message>
    <message>
        <source>Lagoon</source>
        <translation>Lagoa</translation>
    </message>
    <message>
        <source>Dusk</source>
        <translation>Crepúsculo</translation>
    </message>
    <message>
        <source>Balance</source>
        <translation>Balança</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Cinza</translation>
    </message>
</context>
<context>
    <name>SmallFile</name>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>O arquivo não pode ser lido: %1</translation>
    </message>
    <message>
        <source>The file is larger than %1 MB, more than what is asked for here takes; choose another one</source>
        <translation>O arquivo tem mais de %1 MB, mais do que precisa o que se pede aqui; escolha outro</translation>
    </message>
</context>
<context>
    <name>SnapshotEdits</name>
    <message>
        <source>Take Snapshot “%1”</source>
        <translation>Tirar instantâneo “%1”</translation>
    </message>
    <message>
        <source>Remove Snapshot “%1”</source>
        <translation>Remover instantâneo “%1”</translation>
    </message>
    <message>
        <source>Go Back to “%1”</source>
        <translation>Voltar a “%1”</translation>
    </message>
</context>
<context>
    <name>Snapshots</name>
    <message>
        <source>The picture of layer “%1” is no longer in the project&apos;s file</source>
        <translation>A imagem da camada “%1” não está mais no arquivo do projeto</translation>
    </message>
</context>
<context>
    <name>SolverRegistry</name>
    <message>
        <source>Its description has no valid &quot;%1&quot;</source>
        <translation>Sua descrição não tem “%1” válido</translation>
    </message>
    <message>
        <source>Its description cannot be read: %1</source>
        <translation>Sua descrição não pode ser lida: %1</translation>
    </message>
    <message>
        <source>Its description is too large to be one</source>
        <translation>Sua descrição é grande demais para ser uma</translation>
    </message>
    <message>
        <source>Its description is not valid JSON: %1</source>
        <translation>Sua descrição não é JSON válido: %1</translation>
    </message>
    <message>
        <source>Its description is not one of a solver</source>
        <translation>Sua descrição não é a de um solucionador</translation>
    </message>
    <message>
        <source>Its id may hold only small letters, digits and hyphens</source>
        <translation>Seu id só pode conter letras minúsculas, dígitos e hifens</translation>
    </message>
    <message>
        <source>Its module has to be a file beside its description</source>
        <translation>Seu módulo deve ser um arquivo ao lado da descrição</translation>
    </message>
    <message>
        <source>Its module %1 is missing</source>
        <translation>Falta seu módulo %1</translation>
    </message>
    <message>
        <source>Its module cannot be loaded: %1</source>
        <translation>Seu módulo não pode ser carregado: %1</translation>
    </message>
    <message>
        <source>Its module has no entry point %1</source>
        <translation>Seu módulo não tem o ponto de entrada %1</translation>
    </message>
    <message>
        <source>Its module failed at start: %1</source>
        <translation>Seu módulo falhou ao iniciar: %1</translation>
    </message>
    <message>
        <source>Its module failed at start with an unknown exception</source>
        <translation>Seu módulo falhou ao iniciar com uma exceção desconhecida</translation>
    </message>
    <message>
        <source>no plugin was found</source>
        <translation>nenhum plugin foi encontrado</translation>
    </message>
    <message>
        <source>No solver can run here; install one or set DIPWRIGHT_PLUGIN_PATH</source>
        <translation>Nenhum solucionador pode rodar aqui; instale um ou defina DIPWRIGHT_PLUGIN_PATH</translation>
    </message>
    <message>
        <source>There is no such solver; choose one of %1</source>
        <translation>Esse solucionador não existe; escolha um de %1</translation>
    </message>
    <message>
        <source>This solver cannot be used: %1</source>
        <translation>Este solucionador não pode ser usado: %1</translation>
    </message>
    <message>
        <source>It was built for solver interface %1, and this program has %2; get it for this version of the program, or build it anew</source>
        <translation>Ele foi feito para a interface de solucionador %1, e este programa tem a %2; obtenha-o para esta versão do programa ou compile-o de novo</translation>
    </message>
    <message>
        <source>Its module does not fit this program&apos;s solver interface %1, whatever its description says; build it anew</source>
        <translation>O módulo dele não corresponde à interface de solucionador %1 deste programa, seja o que for que diga a descrição; compile-o de novo</translation>
    </message>
    <message>
        <source>It has crashed twice; replace it, or set DIPWRIGHT_RETRY_SOLVERS=1 to try it again</source>
        <translation>Ele travou duas vezes; substitua-o ou defina DIPWRIGHT_RETRY_SOLVERS=1 para tentar de novo</translation>
    </message>
    <message>
        <source>Others can write to %1; take that right from them, or move the plugin</source>
        <translation>Outros podem gravar em %1; tire-lhes esse direito ou mova o plugin</translation>
    </message>
    <message>
        <source>It cannot run here and does not say why; ask whoever made it</source>
        <translation>Ele não pode rodar aqui e não diz por quê; pergunte a quem o fez</translation>
    </message>
    <message>
        <source>The &quot;priority&quot; in its description has to be a whole number from -%1 to %1</source>
        <translation>“priority” na descrição dele tem de ser um número inteiro de -%1 a %1</translation>
    </message>
</context>
<context>
    <name>StateFigures</name>
    <message>
        <source>no result</source>
        <translation>sem resultado</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>igual</translation>
    </message>
    <message>
        <source>%1, better</source>
        <translation>%1, melhor</translation>
    </message>
    <message>
        <source>%1, worse</source>
        <translation>%1, pior</translation>
    </message>
    <message>
        <source>Body painted altogether</source>
        <translation>Corpo pintado ao todo</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Largest stretch of 95 % of the film on the body</source>
        <translation>Maior estiramento de 95 % do filme no corpo</translation>
    </message>
    <message>
        <source>Area that is not certain</source>
        <translation>Área que não é certa</translation>
    </message>
</context>
<context>
    <name>Tolerance</name>
    <message>
        <source>Body along X</source>
        <translation>Corpo ao longo de X</translation>
    </message>
    <message>
        <source>Body along Z</source>
        <translation>Corpo ao longo de Z</translation>
    </message>
    <message>
        <source>Body about X</source>
        <translation>Corpo em torno de X</translation>
    </message>
    <message>
        <source>Body about Y</source>
        <translation>Corpo em torno de Y</translation>
    </message>
    <message>
        <source>Body about Z</source>
        <translation>Corpo em torno de Z</translation>
    </message>
    <message>
        <source>Film along X</source>
        <translation>Filme ao longo de X</translation>
    </message>
    <message>
        <source>Film along Z</source>
        <translation>Filme ao longo de Z</translation>
    </message>
    <message>
        <source>Film about Y</source>
        <translation>Filme em torno de Y</translation>
    </message>
    <message>
        <source>Swell</source>
        <translation>Inchaço</translation>
    </message>
    <message>
        <source>Water level</source>
        <translation>Nível da água</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidade</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxamento</translation>
    </message>
    <message>
        <source>Dipping off its place</source>
        <translation>Mergulhando com desvios</translation>
    </message>
    <message>
        <source>A film that lies off its place does not follow the body; give the film smaller cells or more points</source>
        <translation>Um filme fora do lugar não acompanha o corpo; dê ao filme células menores ou mais pontos</translation>
    </message>
    <message>
        <source>%1 dips with everything off at once come to ±%2 in place of ±%3.</source>
        <translation>%1 imersões com tudo desviado ao mesmo tempo dão ±%2 em vez de ±%3.</translation>
    </message>
    <message>
        <source>%1 dips with everything off at once come to ±%2 in place of ±%3: what the contributors do cannot simply be added here.</source>
        <translation>%1 imersões com tudo desviado ao mesmo tempo dão ±%2 em vez de ±%3: aqui os efeitos não podem simplesmente ser somados.</translation>
    </message>
    <message>
        <source>Zone %1 is not painted.</source>
        <translation>A zona %1 não é pintada.</translation>
    </message>
    <message>
        <source>Zone %1 keeps its limit: %2 % of what is painted is within ±%3, 95 % within ±%4. Most of it comes from: %5.</source>
        <translation>A zona %1 respeita seu limite: %2 % do que é pintado fica dentro de ±%3, 95 % dentro de ±%4. A maior parte vem de: %5.</translation>
    </message>
    <message>
        <source>Zone %1 does not keep its limit: %2 % of what is painted is within ±%3, 95 % only within ±%4. Most of it comes from: %5.</source>
        <translation>A zona %1 não respeita seu limite: %2 % do que é pintado fica dentro de ±%3, 95 % só dentro de ±%4. A maior parte vem de: %5.</translation>
    </message>
</context>
<context>
    <name>Traveller</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>não informado</translation>
    </message>
    <message>
        <source>Dip %1 of %2: %3</source>
        <translation>Mergulho %1 de %2: %3</translation>
    </message>
    <message>
        <source>Traveller of %1, %2</source>
        <translation>Ficha de acompanhamento de %1, %2</translation>
    </message>
    <message>
        <source>%1. %2, sheet %3</source>
        <translation>%1. %2, folha %3</translation>
    </message>
    <message>
        <source>Order: %1</source>
        <translation>Ordem: %1</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>Trabalho %1</translation>
    </message>
    <message>
        <source>Turned about X %1°, then Y %2°, then Z %3°. Its middle %4 mm to the right of the film&apos;s middle and %5 mm towards the film&apos;s lower edge. Solid blue: the water when the dip begins; dashed: when it ends.</source>
        <translation>Girado em X %1°, depois Y %2°, depois Z %3°. Seu meio %4 mm à direita do meio do filme e %5 mm em direção à borda inferior. Azul contínuo: a água quando o mergulho começa; tracejado: quando termina.</translation>
    </message>
    <message>
        <source>No cradle was made for this job; hold the body as drawn.</source>
        <translation>Nenhum berço foi feito para este trabalho; segure o corpo como no desenho.</translation>
    </message>
    <message>
        <source>Cradle %1: its plate shows the same number and job; its arrow points to the film&apos;s upper edge.</source>
        <translation>Berço %1: a placa mostra o mesmo número e trabalho; a seta aponta para a borda superior do filme.</translation>
    </message>
    <message>
        <source>Seen from the film&apos;s lower edge</source>
        <translation>Visto da borda inferior do filme</translation>
    </message>
    <message>
        <source>Seen from the film&apos;s right edge</source>
        <translation>Visto da borda direita do filme</translation>
    </message>
    <message>
        <source>upper edge</source>
        <translation>borda superior</translation>
    </message>
    <message>
        <source>lower edge</source>
        <translation>borda inferior</translation>
    </message>
    <message>
        <source>left edge</source>
        <translation>borda esquerda</translation>
    </message>
    <message>
        <source>From above, ink side up. Crosses: the sheet&apos;s marks as they float; red: the datum pins, at %1 / %2 / %3 mm from the film&apos;s middle (to the right; down); dashed: the body.</source>
        <translation>De cima, lado da tinta para cima. Cruzes: as marcas da folha como flutuam; vermelho: os pinos de referência, a %1 / %2 / %3 mm do meio do filme (à direita; para baixo); tracejado: o corpo.</translation>
    </message>
    <message>
        <source>Dotted: the tank&apos;s marks, %1 × %2 mm apart; the film lies in their middle.</source>
        <translation>Pontilhado: as marcas do tanque, a %1 × %2 mm uma da outra; o filme fica no meio delas.</translation>
    </message>
    <message>
        <source>The tank&apos;s marks are not given.</source>
        <translation>As marcas do tanque não foram informadas.</translation>
    </message>
    <message>
        <source>Film %1 × %2 mm, swell %3 × %4.</source>
        <translation>Filme %1 × %2 mm, dilatação %3 × %4.</translation>
    </message>
    <message>
        <source>No film profile is given.</source>
        <translation>Nenhum perfil de filme foi informado.</translation>
    </message>
    <message>
        <source>%1, lot %2, good until %3.</source>
        <translation>%1, lote %2, válido até %3.</translation>
    </message>
    <message>
        <source>At the tank</source>
        <translation>No tanque</translation>
    </message>
    <message>
        <source>Done by</source>
        <translation>Feito por</translation>
    </message>
    <message>
        <source>Date, time</source>
        <translation>Data, hora</translation>
    </message>
    <message>
        <source>Checked by</source>
        <translation>Conferido por</translation>
    </message>
    <message>
        <source>Swell measured on %1.</source>
        <translation>Inchamento medido em %1.</translation>
    </message>
    <message>
        <source>Swell guessed, not measured.</source>
        <translation>Inchamento suposto, não medido.</translation>
    </message>
    <message>
        <source>Verdict: %1</source>
        <translation>Veredito: %1</translation>
    </message>
    <message>
        <source>as the film maker says (no time given)</source>
        <translation>como indica o fabricante do filme (tempo não informado)</translation>
    </message>
    <message>
        <source>Lay sheet %1 on the water, ink side up; its upper edge lies where the arrow of the plate points.</source>
        <translation>Pôr a folha %1 na água, lado da tinta para cima; a borda superior fica para onde aponta a seta da placa.</translation>
    </message>
    <message>
        <source>Soak the film: %1</source>
        <translation>Deixar o filme de molho: %1</translation>
    </message>
    <message>
        <source>Spray the activator, then wait: %1</source>
        <translation>Borrifar o ativador, depois esperar: %1</translation>
    </message>
    <message>
        <source>Dip from %1 mm above the water to %2 mm below it, at %3 mm/s: %4 s</source>
        <translation>Mergulhar de %1 mm acima da água até %2 mm abaixo, a %3 mm/s: %4 s</translation>
    </message>
    <message>
        <source>Hold under water for %1 s, clear the film around the part, lift it out at %2 mm/s</source>
        <translation>Manter debaixo d&apos;água por %1 s, afastar o filme ao redor da peça, retirar a %2 mm/s</translation>
    </message>
    <message>
        <source>Let it flash off before rinsing: %1</source>
        <translation>Deixar evaporar antes de enxaguar: %1</translation>
    </message>
    <message>
        <source>Rinse and dry: %1</source>
        <translation>Enxaguar e secar: %1</translation>
    </message>
    <message>
        <source>Compare the part with the picture before dip %1: colour in its place, no tear, no fold, dry where the next cradle holds it</source>
        <translation>Antes da imersão %1, comparar a peça com a imagem: cor no lugar, sem rasgo, sem dobra, seca onde o próximo berço a segura</translation>
    </message>
    <message>
        <source>Compare the part with the picture</source>
        <translation>Comparar a peça com a imagem</translation>
    </message>
    <message>
        <source>After dip %1 the part should look like this: seen from the film&apos;s lower edge, from its right edge, and from below</source>
        <translation>Depois da imersão %1 a peça deve ficar assim: vista da borda inferior do filme, da borda direita e de baixo</translation>
    </message>
</context>
<context>
    <name>Units</name>
    <message>
        <source> in</source>
        <translation> pol</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> in/s</source>
        <translation> pol/s</translation>
    </message>
    <message>
        <source> mm/s</source>
        <translation> mm/s</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source> cells</source>
        <translation> células</translation>
    </message>
    <message>
        <source> D</source>
        <translation> D</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source> %/s</source>
        <translation> %/s</translation>
    </message>
    <message>
        <source>%1 in²</source>
        <translation>%1 pol²</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message>
        <source>Not judged</source>
        <translation>Não avaliado</translation>
    </message>
    <message>
        <source>Print it</source>
        <translation>Pode imprimir</translation>
    </message>
    <message>
        <source>Do not print</source>
        <translation>Não imprima</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Zone %1: %2</source>
        <translation>Zona %1: %2</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The numerical error was not estimated.</source>
        <translation>O erro numérico não foi estimado.</translation>
    </message>
    <message>
        <source>The numerical error could not be estimated: %1.</source>
        <translation>O erro numérico não pôde ser estimado: %1.</translation>
    </message>
    <message>
        <source>No place is painted both by this dip and by coarser ones.</source>
        <translation>Nenhum lugar é pintado tanto por esta imersão como por outras mais grossas.</translation>
    </message>
    <message>
        <source>95 % of the sheet is within %1 (numerical error).</source>
        <translation>95 % da folha ficam dentro de %1 (erro numérico).</translation>
    </message>
    <message>
        <source>Numerical error: 95 % of the painted area is within %1; the limit is %2. Set Film &gt; Cells to %3, turn the body, or dip it twice.</source>
        <translation>Erro numérico: 95 % da área pintada ficam dentro de %1; o limite é %2. Ponha Filme &gt; Células em %3, gire o corpo ou mergulhe-o duas vezes.</translation>
    </message>
    <message>
        <source>Numerical error: 95 % of the painted area is within %1; the limit is %2. Set more points (Film &gt; Points), turn the body, or dip it twice.</source>
        <translation>Erro numérico: 95 % da área pintada ficam dentro de %1; o limite é %2. Ponha mais pontos (Filme &gt; Pontos), gire o corpo ou mergulhe-o duas vezes.</translation>
    </message>
    <message>
        <source>Numerical error: 95 % of the painted area is within %1; the limit is %2. Turn the body, dip it twice, or set much smaller cells or more points (Film &gt; Cells).</source>
        <translation>Erro numérico: 95 % da área pintada ficam dentro de %1; o limite é %2. Gire o corpo, mergulhe-o duas vezes ou ponha células bem menores ou mais pontos (Filme &gt; Células).</translation>
    </message>
    <message>
        <source>Numerical error: 95 % of the painted area is within %1; the limit is %2. Most of it comes from the steps: set a smaller Dipping &gt; Step.</source>
        <translation>Erro numérico: 95 % da área pintada ficam dentro de %1; o limite é %2. A maior parte vem dos passos: ponha um valor menor em Imersão &gt; Passo.</translation>
    </message>
    <message>
        <source>Numerical error: %1 % of the painted area may be off by more than %2. Check the places in the list.</source>
        <translation>Erro numérico: %1 % da área pintada podem desviar mais de %2. Verifique os lugares da lista.</translation>
    </message>
    <message>
        <source>The border of the paint is uncertain: only finer or only coarser dips paint %1 % of the body. Set smaller cells (Film &gt; Cells).</source>
        <translation>A borda da tinta é incerta: %1 % do corpo são pintados só por imersões mais finas ou só por mais grossas. Ponha células menores (Filme &gt; Células).</translation>
    </message>
    <message>
        <source>%1 steps of the dip did not reach equilibrium; up to %2 % of the elastic force remained. Set smaller cells (Film &gt; Cells).</source>
        <translation>%1 passos da imersão não alcançaram o equilíbrio; restaram até %2 % da força elástica. Ponha células menores (Filme &gt; Células).</translation>
    </message>
    <message>
        <source>The film paints nothing of the body. Check the model&apos;s unit, its place over the film, and the depth of the dip.</source>
        <translation>O filme não pinta nada do corpo. Verifique a unidade do modelo, o lugar dele sobre o filme e a profundidade da imersão.</translation>
    </message>
    <message>
        <source>Trapped air keeps %1 % of the body dry; the limit is %2 %. Turn the body so that the air escapes, or drill a vent hole.</source>
        <translation>Ar preso mantém secos %1 % do corpo; o limite é %2 %. Gire o corpo para que o ar saia, ou faça um furo de respiro.</translation>
    </message>
    <message>
        <source>%1 % of the painted area will be too pale; the limit is %2 %. The film stretches more than Ink &gt; Ink limit can compensate. Turn the body, or choose lighter colours.</source>
        <translation>%1 % da área pintada ficarão claros demais; o limite é %2 %. O filme estica mais do que Tinta &gt; Limite de tinta consegue compensar. Gire o corpo ou escolha cores mais claras.</translation>
    </message>
    <message>
        <source>The film tore or was released on %1 % of the painted area; the limit is %2 %. Turn the body, or dip it twice.</source>
        <translation>O filme rasgou ou se soltou em %1 % da área pintada; o limite é %2 %. Gire o corpo ou mergulhe-o duas vezes.</translation>
    </message>
    <message>
        <source>The painted film comes within %1 of the film&apos;s edge; at least %2 are required. Use a larger film, or move the body to the film&apos;s centre.</source>
        <translation>O filme que pinta chega a %1 da borda do filme; são necessários pelo menos %2. Use um filme maior ou leve o corpo ao meio do filme.</translation>
    </message>
    <message>
        <source>Neither dip reaches %1 % of the body; the limit is %2 %. Turn one of the poses.</source>
        <translation>Nenhuma imersão alcança %1 % do corpo; o limite é %2 %. Gire uma das poses.</translation>
    </message>
    <message>
        <source>%1 % of the overlap is too narrow; the limit is %2 %. The second film shows there if it is misplaced. Widen Join &gt; Overlap, or turn one of the poses.</source>
        <translation>%1 % da sobreposição são estreitos demais; o limite é %2 %. O segundo filme aparece ali se ficar deslocado. Alargue Junção &gt; Sobreposição ou gire uma das poses.</translation>
    </message>
    <message>
        <source>%1 % is not painted; the limit is %2 %. Turn the body so that film reaches it.</source>
        <translation>%1 % não são pintados; o limite é %2 %. Gire o corpo para que o filme chegue lá.</translation>
    </message>
    <message>
        <source>Handling and numerical error together: 95 % of the painted area is within ±%1; the limit is ±%2. Tighten the largest contributor, or turn the body.</source>
        <translation>Manuseio e erro numérico juntos: 95 % da área pintada ficam dentro de ±%1; o limite é ±%2. Reduza a maior contribuição ou gire o corpo.</translation>
    </message>
    <message>
        <source>The model has no texture and no artwork: one plain colour is printed.</source>
        <translation>O modelo não tem textura nem arte: imprime-se uma só cor.</translation>
    </message>
    <message>
        <source>Model: %1</source>
        <translation>Modelo: %1</translation>
    </message>
    <message>
        <source>The film&apos;s swell is guessed, not measured: the picture may be a few per cent too large or too small. Measure the film.</source>
        <translation>O inchamento do filme é estimado, não medido: a imagem pode ficar alguns por cento maior ou menor. Meça o filme.</translation>
    </message>
    <message>
        <source>Check these places first</source>
        <translation>Verifique antes estes lugares</translation>
    </message>
    <message>
        <source>%1 may be off by more than %2, at most by %3</source>
        <translation>%1 podem desviar mais de %2, no máximo %3</translation>
    </message>
</context>
<context>
    <name>ZoneAppearance</name>
    <message>
        <source>Zone %1, ±%2 mm</source>
        <translation>Zona %1, ±%2 mm</translation>
    </message>
    <message>
        <source>Pale: far within the limit</source>
        <translation>Pálido: bem dentro do limite</translation>
    </message>
    <message>
        <source>Past the limit</source>
        <translation>Além do limite</translation>
    </message>
    <message>
        <source>Not painted</source>
        <translation>Não pintado</translation>
    </message>
</context>
<context>
    <name>dipwright::Artwork</name>
    <message>
        <source>The artwork has %1 layers, as many as there may be; remove one</source>
        <translation>A arte tem %1 camadas, o máximo permitido; remova uma</translation>
    </message>
    <message>
        <source>The text “%1” is to be set in %2, which this computer does not have, and is set in another; install that font or choose one that is here</source>
        <translation>O texto “%1” deve usar a fonte %2, que este computador não tem, e usa outra; instale essa fonte ou escolha uma que exista aqui</translation>
    </message>
    <message>
        <source>The picture of the layer “%1”</source>
        <translation>A imagem da camada “%1”</translation>
    </message>
</context>
<context>
    <name>dipwright::ArtworkController</name>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Carbon</source>
        <translation>Carbono</translation>
    </message>
    <message>
        <source>Camouflage</source>
        <translation>Camuflagem</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Madeira</translation>
    </message>
    <message>
        <source>Change Layer</source>
        <translation>Alterar camada</translation>
    </message>
    <message>
        <source>Base Colour</source>
        <translation>Cor de base</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Adicionar %1</translation>
    </message>
    <message>
        <source>Reading the picture</source>
        <translation>Lendo a imagem</translation>
    </message>
    <message>
        <source>Add Picture</source>
        <translation>Adicionar imagem</translation>
    </message>
    <message>
        <source>Move Layer</source>
        <translation>Mover camada</translation>
    </message>
    <message>
        <source>Remove Layer</source>
        <translation>Remover camada</translation>
    </message>
    <message>
        <source>Turn Layer</source>
        <translation>Girar camada</translation>
    </message>
    <message>
        <source>Size of Layer</source>
        <translation>Tamanho da camada</translation>
    </message>
</context>
<context>
    <name>dipwright::ArtworkPage</name>
    <message>
        <source>Add &amp;Picture…</source>
        <translation>Adicionar &amp;imagem…</translation>
    </message>
    <message>
        <source>Lays a picture on the body. A picture dropped on the body in the view is laid where it was dropped.</source>
        <translation>Põe uma imagem sobre o corpo. Uma imagem solta sobre o corpo na vista fica onde foi solta.</translation>
    </message>
    <message>
        <source>Add &amp;Text</source>
        <translation>Adicionar &amp;texto</translation>
    </message>
    <message>
        <source>Add Pa&amp;ttern</source>
        <translation>Adicionar &amp;padrão</translation>
    </message>
    <message>
        <source>Carbon</source>
        <translation>Carbono</translation>
    </message>
    <message>
        <source>Camouflage</source>
        <translation>Camuflagem</translation>
    </message>
    <message>
        <source>Wood</source>
        <translation>Madeira</translation>
    </message>
    <message>
        <source>Layers, the uppermost first</source>
        <translation>Camadas, a de cima primeiro</translation>
    </message>
    <message>
        <source>The layers, the uppermost first. The tick shows or hides one, a double click renames it; Delete removes it, Ctrl with the arrows moves it.</source>
        <translation>As camadas, a de cima primeiro. A marca mostra ou esconde uma, um clique duplo muda o nome; Delete a remove, Ctrl com as setas a move.</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Para cima</translation>
    </message>
    <message>
        <source>Lays the layer over the next one (Ctrl+Up)</source>
        <translation>Põe a camada acima da seguinte (Ctrl+Cima)</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Para baixo</translation>
    </message>
    <message>
        <source>Lays the layer under the next one (Ctrl+Down)</source>
        <translation>Põe a camada abaixo da seguinte (Ctrl+Baixo)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remover</translation>
    </message>
    <message>
        <source>Removes the layer (Delete)</source>
        <translation>Remove a camada (Delete)</translation>
    </message>
    <message>
        <source>Base colour</source>
        <translation>Cor de base</translation>
    </message>
    <message>
        <source>What lies below all layers; white is no ink. Without it the model shows what it looks like by itself.</source>
        <translation>O que fica abaixo de todas as camadas; branco é nenhuma tinta. Sem ela o modelo mostra sua própria aparência.</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>Fonte</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Cor</translation>
    </message>
    <message>
        <source>Light colour</source>
        <translation>Cor clara</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variante</translation>
    </message>
    <message>
        <source>Each number makes another pattern of the same kind.</source>
        <translation>Cada número dá outro padrão do mesmo tipo.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidade</translation>
    </message>
    <message>
        <source>100 %: hides what lies below it.</source>
        <translation>100 %: esconde o que está abaixo.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Laid on</source>
        <translation>Aplicação</translation>
    </message>
    <message>
        <source>As a decal</source>
        <translation>Como decalque</translation>
    </message>
    <message>
        <source>Along an axis</source>
        <translation>Ao longo de um eixo</translation>
    </message>
    <message>
        <source>Round an axis</source>
        <translation>Em torno de um eixo</translation>
    </message>
    <message>
        <source>From six sides</source>
        <translation>De seis lados</translation>
    </message>
    <message>
        <source>A decal keeps lengths and straight lines round its middle. The others are for patterns over all of the body.</source>
        <translation>Um decalque mantém comprimentos e linhas retas em torno do seu meio. Os outros são para padrões sobre todo o corpo.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eixo</translation>
    </message>
    <message>
        <source>What is shown fits in, its proportions kept.</source>
        <translation>O que é mostrado cabe dentro, mantidas as proporções.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largura</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Counterclockwise as seen from outside.</source>
        <translation>No sentido anti-horário, visto de fora.</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Repeated every</source>
        <translation>Repetido a cada</translation>
    </message>
    <message>
        <source>The width of one repeat on the body; round an axis a whole number of them is laid.</source>
        <translation>A largura de uma repetição sobre o corpo; em torno de um eixo cabe um número inteiro delas.</translation>
    </message>
    <message>
        <source>once</source>
        <translation>uma vez</translation>
    </message>
    <message>
        <source>Middle, X</source>
        <translation>Meio, X</translation>
    </message>
    <message>
        <source>Middle, Y</source>
        <translation>Meio, Y</translation>
    </message>
    <message>
        <source>Middle, Z</source>
        <translation>Meio, Z</translation>
    </message>
    <message>
        <source>In the model&apos;s coordinates; of a decal the nearest place of the body counts.</source>
        <translation>Em coordenadas do modelo; de um decalque conta o lugar mais próximo do corpo.</translation>
    </message>
    <message>
        <source>the model&apos;s own</source>
        <translation>a do modelo</translation>
    </message>
    <message>
        <source>Spot ink</source>
        <translation>Tinta especial</translation>
    </message>
    <message>
        <source>printed in its colours</source>
        <translation>impressa em suas cores</translation>
    </message>
    <message>
        <source>The name of a varnish or of an ink of its own, as the printer knows it. The layer is then a plate beside the four inks, in PDF and TIFF in CMYK; what it covers counts, and not its colours.</source>
        <translation>O nome de um verniz ou de uma tinta própria, como a impressora a conhece. A camada é então uma chapa ao lado das quatro tintas, em PDF e TIFF em CMYK; conta o que ela cobre, não as suas cores.</translation>
    </message>
    <message>
        <source>Looks like</source>
        <translation>Parece com</translation>
    </message>
    <message>
        <source>What stands for the ink where nobody knows its name.</source>
        <translation>O que representa a tinta onde ninguém conhece o seu nome.</translation>
    </message>
    <message>
        <source>Outside the colours</source>
        <translation>Por fora das cores</translation>
    </message>
    <message>
        <source>Printed before the four inks, so that it ends up outside them, as a varnish does; else after them, towards the part.</source>
        <translation>Impressa antes das quatro tintas, de modo que fica por fora delas, como um verniz; senão depois delas, do lado da peça.</translation>
    </message>
</context>
<context>
    <name>dipwright::ArtworkPainter</name>
    <message>
        <source>Painting the artwork</source>
        <translation>Pintando a arte</translation>
    </message>
</context>
<context>
    <name>dipwright::BodyHandles</name>
    <message>
        <source>Turn Body</source>
        <translation>Girar corpo</translation>
    </message>
    <message>
        <source>Turned by %1° about %2; with Shift by steps of %3°</source>
        <translation>Girado %1° em torno de %2; com Shift em passos de %3°</translation>
    </message>
    <message>
        <source>Change Depth</source>
        <translation>Alterar profundidade</translation>
    </message>
    <message>
        <source>Dipped %1 deep; with Shift by steps of %2</source>
        <translation>Mergulhado %1 de profundidade; com Shift em passos de %2</translation>
    </message>
    <message>
        <source>Move Body</source>
        <translation>Mover corpo</translation>
    </message>
    <message>
        <source>Moved to %1 along %2; with Shift by steps of %3</source>
        <translation>Movido para %1 ao longo de %2; com Shift em passos de %3</translation>
    </message>
</context>
<context>
    <name>dipwright::BodyMenu</name>
    <message>
        <source>&amp;Lay This Face Down</source>
        <translation>&amp;Pôr esta face para baixo</translation>
    </message>
    <message>
        <source>This Face Must Be &amp;Good (Zone A)</source>
        <translation>Esta face precisa ficar &amp;boa (zona A)</translation>
    </message>
    <message>
        <source>&amp;Turn</source>
        <translation>&amp;Girar</translation>
    </message>
    <message>
        <source>&amp;Move</source>
        <translation>&amp;Mover</translation>
    </message>
    <message>
        <source>Turn Body</source>
        <translation>Girar corpo</translation>
    </message>
    <message>
        <source>Move Body</source>
        <translation>Mover corpo</translation>
    </message>
    <message>
        <source>Lay Face Down</source>
        <translation>Pôr face para baixo</translation>
    </message>
</context>
<context>
    <name>dipwright::FinishedPartPreview</name>
    <message>
        <source>Printing the body</source>
        <translation>Imprimindo o corpo</translation>
    </message>
</context>
<context>
    <name>dipwright::BodyShare</name>
    <message>
        <source>Sharing out the body</source>
        <translation>Repartindo o corpo</translation>
    </message>
</context>
<context>
    <name>dipwright::Budgets</name>
    <message>
        <source>The file is larger than %1 MB; reduce it</source>
        <translation>O arquivo é maior que %1 MB; reduza-o</translation>
    </message>
    <message>
        <source>The model names more than %1 other files; reduce it</source>
        <translation>O modelo cita mais de %1 outros arquivos; reduza-o</translation>
    </message>
    <message>
        <source>The model has more than %1 million triangles, too many for a file of its size or for any computer; reduce it</source>
        <translation>O modelo tem mais de %1 milhões de triângulos, demais para um arquivo deste tamanho ou para qualquer computador; reduza-o</translation>
    </message>
    <message>
        <source>A face of the model has more than %1 corners; cut it into triangles in a modelling program</source>
        <translation>Uma face do modelo tem mais de %1 cantos; divida-a em triângulos em um programa de modelagem</translation>
    </message>
    <message>
        <source>The model cannot be read: its parts hold one another more than %1 deep; join them in a modelling program</source>
        <translation>O modelo não pode ser lido: suas partes contêm umas às outras em mais de %1 níveis; una-as em um programa de modelagem</translation>
    </message>
    <message>
        <source>The model has more than %1 materials; reduce them</source>
        <translation>O modelo tem mais de %1 materiais; reduza-os</translation>
    </message>
    <message>
        <source>The file would unpack to more than %1 MB, more than any of its size needs, and is not opened; ask whoever made it for another</source>
        <translation>O arquivo ocuparia descompactado mais de %1 MB, mais do que qualquer um do seu tamanho precisa, e não é aberto; peça outro a quem o fez</translation>
    </message>
    <message>
        <source>The file holds more entries than %1 and is not opened; ask whoever made it for another</source>
        <translation>O arquivo contém mais entradas que %1 e não é aberto; peça outro a quem o fez</translation>
    </message>
    <message>
        <source>project.json is larger than %1 MB and is not read; ask whoever made the project for another</source>
        <translation>project.json é maior que %1 MB e não é lido; peça outro projeto a quem o fez</translation>
    </message>
    <message>
        <source>The project holds more than %1 MB that is not its own; take that out with an archive program</source>
        <translation>O projeto contém mais de %1 MB que não são seus; retire-os com um programa de arquivamento</translation>
    </message>
    <message>
        <source>The texture has more than %1 pixels a side; make it smaller</source>
        <translation>A textura tem mais de %1 pixels por lado; diminua-a</translation>
    </message>
    <message>
        <source>The pictures have more than %1 million pixels together, too many for files of their size or for any sheet; make them smaller</source>
        <translation>As imagens têm juntas mais de %1 milhões de pixels, demais para arquivos do seu tamanho ou para qualquer folha; diminua-as</translation>
    </message>
    <message>
        <source>Reading the file takes more than %1 MB of memory, more than any of its size needs; reduce it or save it anew</source>
        <translation>Ler o arquivo exige mais de %1 MB de memória, mais do que qualquer um do seu tamanho precisa; reduza-o ou salve-o de novo</translation>
    </message>
    <message>
        <source>Reading the file takes more than %1 seconds, more than any of its size needs; reduce it or save it anew</source>
        <translation>Ler o arquivo leva mais de %1 segundos, mais do que qualquer um do seu tamanho precisa; reduza-o ou salve-o de novo</translation>
    </message>
    <message>
        <source>The file&apos;s values hold one another more than %1 deep and it is not read; ask whoever made it for another</source>
        <translation>Os valores do arquivo contêm uns aos outros em mais de %1 níveis e ele não é lido; peça outro a quem o fez</translation>
    </message>
    <message>
        <source>The file holds more than %1 million values and is not read; ask whoever made it for another</source>
        <translation>O arquivo contém mais de %1 milhões de valores e não é lido; peça outro a quem o fez</translation>
    </message>
</context>
<context>
    <name>dipwright::BuiltController</name>
    <message>
        <source>Looking for what repeats</source>
        <translation>Procurando o que se repete</translation>
    </message>
    <message>
        <source>As Built</source>
        <translation>Como saiu</translation>
    </message>
    <message>
        <source>Measuring the part on the sheet</source>
        <translation>Medindo a peça na folha</translation>
    </message>
    <message>
        <source>Keep Part</source>
        <translation>Guardar peça</translation>
    </message>
</context>
<context>
    <name>dipwright::BuiltPage</name>
    <message>
        <source>&amp;Correct the next sheets</source>
        <translation>&amp;Corrigir as próximas folhas</translation>
    </message>
    <message>
        <source>What repeats, and the correction</source>
        <translation>O que se repete e a correção</translation>
    </message>
    <message>
        <source>Parts that the job keeps</source>
        <translation>Peças que o trabalho guarda</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>Accepted by</source>
        <translation>Aceita por</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Desvio</translation>
    </message>
    <message>
        <source>On the sheet, root mean square</source>
        <translation>Na folha, média quadrática</translation>
    </message>
    <message>
        <source>Who says that the part may count</source>
        <translation>Quem diz que a peça pode contar</translation>
    </message>
    <message>
        <source>&amp;Keep Part</source>
        <translation>&amp;Guardar peça</translation>
    </message>
    <message>
        <source>Keeps with the job how far the print of the measured part is off</source>
        <translation>Guarda com o trabalho o desvio da impressão da peça medida</translation>
    </message>
    <message>
        <source>Prints the next sheets so that what repeats does not come again</source>
        <translation>Imprime as próximas folhas de modo que o que se repete não volte</translation>
    </message>
    <message>
        <source>Strength of the correction</source>
        <translation>Intensidade da correção</translation>
    </message>
    <message>
        <source>How much of what repeats is taken off the next sheets</source>
        <translation>Quanto do que se repete é descontado nas próximas folhas</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>Dip %1</source>
        <translation>Imersão %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>The next sheets are corrected so.</source>
        <translation>As próximas folhas são corrigidas assim.</translation>
    </message>
    <message>
        <source>The next sheets are not corrected: this is what they would be.</source>
        <translation>As próximas folhas não são corrigidas: assim seriam.</translation>
    </message>
    <message>
        <source>Keep the part that was measured: the job then has its photos, how far its print is off, and who accepted it.</source>
        <translation>Guarde a peça medida: o trabalho passa a ter as fotos, o desvio da impressão e quem a aceitou.</translation>
    </message>
    <message>
        <source>To keep a part, find the corners of its print on the page “Dipped Part”, with pairs that are places of the body itself.</source>
        <translation>Para guardar uma peça, procure os cantos da impressão na página “Peça mergulhada”, com pares que são lugares do próprio corpo.</translation>
    </message>
    <message>
        <source>The repeating error of the parts is shown here.</source>
        <translation>Aqui se vê o erro que se repete nas peças.</translation>
    </message>
</context>
<context>
    <name>dipwright::BuiltPlaces</name>
    <message>
        <source>None of the places is seen on film that lies on the body; are the photos of this job?</source>
        <translation>Nenhum dos lugares é visto em filme que está sobre o corpo; as fotos são deste trabalho?</translation>
    </message>
    <message>
        <source>The job keeps %1 parts and %2 places at most, and would have more</source>
        <translation>O trabalho guarda no máximo %1 peças e %2 lugares e teria mais</translation>
    </message>
    <message>
        <source>The job keeps the part of these photos already; the same part twice would count as two that agree</source>
        <translation>O trabalho já guarda a peça destas fotos; a mesma peça duas vezes contaria como duas que concordam</translation>
    </message>
</context>
<context>
    <name>dipwright::CalibrationDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Measure: the printer as it is</source>
        <translation>Medir: a impressora como ela é</translation>
    </message>
    <message>
        <source>Verify: corrected by the profile</source>
        <translation>Verificar: corrigida pelo perfil</translation>
    </message>
    <message>
        <source>Horizontal ruler</source>
        <translation>Régua horizontal</translation>
    </message>
    <message>
        <source>Vertical ruler</source>
        <translation>Régua vertical</translation>
    </message>
    <message>
        <source>&amp;Print Page</source>
        <translation>Im&amp;primir página</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Salvar como PDF…</translation>
    </message>
    <message>
        <source>&amp;Take over into Profile</source>
        <translation>&amp;Guardar no perfil</translation>
    </message>
    <message>
        <source>Calibrate Printer</source>
        <translation>Calibrar impressora</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Cancelado.</translation>
    </message>
    <message>
        <source>1. Print the page</source>
        <translation>1. Imprimir a página</translation>
    </message>
    <message>
        <source>P&amp;rofile</source>
        <translation>Pe&amp;rfil</translation>
    </message>
    <message>
        <source>Pr&amp;inter</source>
        <translation>&amp;Impressora</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>P&amp;apel</translation>
    </message>
    <message>
        <source>The profile that the scale goes into. “Profiles” makes new ones.</source>
        <translation>O perfil que recebe a escala. Em “Perfis” se criam novos.</translation>
    </message>
    <message>
        <source>2. Measure its rulers</source>
        <translation>2. Medir as réguas</translation>
    </message>
    <message>
        <source>&amp;Horizontal</source>
        <translation>&amp;Horizontal</translation>
    </message>
    <message>
        <source>&amp;Vertical</source>
        <translation>&amp;Vertical</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Looking for printers</source>
        <translation>Procurando impressoras</translation>
    </message>
    <message>
        <source>No printer is set up on this machine. Save the page as PDF and print it elsewhere, at 100 %.</source>
        <translation>Nenhuma impressora está configurada nesta máquina. Salve a página como PDF e imprima em outro lugar, a 100 %.</translation>
    </message>
    <message>
        <source>instead of %1 mm</source>
        <translation>em vez de %1 mm</translation>
    </message>
    <message>
        <source>Print the page, measure both rulers from the first to the last line to a tenth of a millimetre, and type what they show. Then verify with the second page.</source>
        <translation>Imprima a página, meça as duas réguas do primeiro ao último traço com precisão de um décimo de milímetro e digite o que elas mostram. Depois verifique com a segunda página.</translation>
    </message>
    <message>
        <source>X %1, Y %2</source>
        <translation>X %1, Y %2</translation>
    </message>
    <message>
        <source>Printing</source>
        <translation>Imprimindo</translation>
    </message>
    <message>
        <source>Printed on %1. Let it dry, then measure.</source>
        <translation>Impresso em %1. Deixe secar e depois meça.</translation>
    </message>
    <message>
        <source>Handed to the queue of %1</source>
        <translation>Entregue à fila de %1</translation>
    </message>
    <message>
        <source>Save Page</source>
        <translation>Salvar página</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>calibração</translation>
    </message>
    <message>
        <source>Wrote %1. Print it at 100 %, without “fit to page”.</source>
        <translation>%1 gravado. Imprima a 100 %, sem “ajustar à página”.</translation>
    </message>
    <message>
        <source>%1 now has the scale X %2, Y %3. Print the second page to verify it.</source>
        <translation>%1 agora tem a escala X %2, Y %3. Imprima a segunda página para verificar.</translation>
    </message>
    <message>
        <source>What the printed ruler measures, to a tenth of a millimetre.</source>
        <translation>Quanto mede a régua impressa, até um décimo de milímetro.</translation>
    </message>
    <message>
        <source>The printers that are set up on this machine.</source>
        <translation>As impressoras instaladas nesta máquina.</translation>
    </message>
    <message>
        <source>The paper that is in the printer.</source>
        <translation>O papel que está na impressora.</translation>
    </message>
    <message>
        <source>Rulers without correction, to be measured.</source>
        <translation>Réguas sem correção, para medir.</translation>
    </message>
    <message>
        <source>The same rulers corrected, which must now measure what they say.</source>
        <translation>As mesmas réguas corrigidas, que agora devem medir o que dizem.</translation>
    </message>
    <message>
        <source>None is set up</source>
        <translation>Nenhuma configurada</translation>
    </message>
</context>
<context>
    <name>dipwright::CalibrationPage</name>
    <message>
        <source>The horizontal ruler must measure %1 mm and the vertical one %2 mm from the first to the last line.</source>
        <translation>A régua horizontal deve medir %1 mm e a vertical %2 mm, da primeira à última linha.</translation>
    </message>
    <message>
        <source>If either is more than 0.2 mm off, measure and calibrate once more.</source>
        <translation>Se alguma estiver mais de 0,2 mm fora, meça e calibre de novo.</translation>
    </message>
    <message>
        <source>Type what they do measure, to a tenth of a millimetre, into the printer&apos;s profile.</source>
        <translation>Digite o que elas medem de fato, ao décimo de milímetro, no perfil da impressora.</translation>
    </message>
    <message>
        <source>Corrected for X %1, Y %2</source>
        <translation>Corrigido para X %1, Y %2</translation>
    </message>
    <message>
        <source>Not corrected: X 1, Y 1</source>
        <translation>Sem correção: X 1, Y 1</translation>
    </message>
    <message>
        <source>Verification of the printer&apos;s scale</source>
        <translation>Verificação da escala da impressora</translation>
    </message>
    <message>
        <source>Calibration of the printer&apos;s scale</source>
        <translation>Calibração da escala da impressora</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm is too small to calibrate a printer with; take A5 or larger</source>
        <translation>Papel de %1 × %2 mm é pequeno demais para calibrar uma impressora; use A5 ou maior</translation>
    </message>
    <message>
        <source>The calibration page cannot be written: %1</source>
        <translation>A página de calibração não pode ser gravada: %1</translation>
    </message>
    <message>
        <source>%1 mm in place of %2 mm is more than 10 % off; switch off all scaling in the printer&apos;s settings, print the page anew and measure again</source>
        <translation>%1 mm em vez de %2 mm passa de 10 % de erro; desligue toda escala nas configurações da impressora, imprima a página de novo e meça outra vez</translation>
    </message>
</context>
<context>
    <name>dipwright::NumericalErrorCheck</name>
    <message>
        <source>Checking the certainty</source>
        <translation>Verificando a confiabilidade</translation>
    </message>
    <message>
        <source>Check Certainty</source>
        <translation>Verificar confiabilidade</translation>
    </message>
</context>
<context>
    <name>dipwright::NumericalErrorDialog</name>
    <message>
        <source>How far the sheet moves</source>
        <translation>Quanto a folha se desloca</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>With steps half as long</source>
        <translation>Com passos de metade do tamanho</translation>
    </message>
    <message>
        <source>With film cells half as wide</source>
        <translation>Com células do filme de metade da largura</translation>
    </message>
    <message>
        <source>Certainty of the sheet</source>
        <translation>Confiabilidade da folha</translation>
    </message>
    <message>
        <source>Certainty of the Sheets</source>
        <translation>Confiabilidade das folhas</translation>
    </message>
    <message>
        <source>&amp;Save Maps…</source>
        <translation>&amp;Salvar mapas…</translation>
    </message>
    <message>
        <source>Save Maps to a Folder</source>
        <translation>Salvar mapas em uma pasta</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Média</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Painted twice</source>
        <translation>Nas duas</translation>
    </message>
    <message>
        <source>Painted once</source>
        <translation>Em uma só</translation>
    </message>
    <message>
        <source>The part of the body that is painted by both dips</source>
        <translation>A parte do corpo pintada pelas duas imersões</translation>
    </message>
    <message>
        <source>The part of the body that is painted by one of the dips only</source>
        <translation>A parte do corpo pintada por só uma das imersões</translation>
    </message>
    <message>
        <source>%1: nothing is painted that could be compared.</source>
        <translation>%1: nada é pintado que se possa comparar.</translation>
    </message>
    <message>
        <source>%1: this sheet is certain. 95 % of it moves by %2 or less when it is computed more finely.</source>
        <translation>%1: esta folha é confiável. 95 % dela deslocam-se %2 ou menos quando é calculada com mais finura.</translation>
    </message>
    <message>
        <source>These are the figures of the project as it was before the last changes.</source>
        <translation>Estes são os números do projeto como era antes das últimas mudanças.</translation>
    </message>
    <message>
        <source>%1: this sheet is not certain. 95 % of it moves by up to %2 when it is computed more finely; give the film smaller cells or more points, turn the body, or dip it in two immersions.</source>
        <translation>%1: esta folha não é confiável. 95 % dela deslocam-se até %2 quando é calculada com mais finura; dê ao filme células menores ou mais pontos, gire o corpo ou mergulhe-o em duas imersões.</translation>
    </message>
</context>
<context>
    <name>dipwright::VerdictPanel</name>
    <message>
        <source>Certainty of the sheet</source>
        <translation>Certeza da folha</translation>
    </message>
    <message>
        <source>Run the dip to see how far the sheet may be off.</source>
        <translation>Execute a imersão para ver quanto a folha pode desviar.</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredito</translation>
    </message>
</context>
<context>
    <name>dipwright::CompareWindow</name>
    <message>
        <source>Side by Side</source>
        <translation>Lado a lado</translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation>O que se mostra</translation>
    </message>
    <message>
        <source>What both bodies wear: the film&apos;s lines, how far it is drawn out, or what is painted</source>
        <translation>O que os dois corpos vestem: as linhas do filme, quanto ele é esticado ou o que é pintado</translation>
    </message>
    <message>
        <source>Film on the body</source>
        <translation>Filme no corpo</translation>
    </message>
    <message>
        <source>Stretch of the film</source>
        <translation>Estiramento do filme</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Cobertura</translation>
    </message>
    <message>
        <source>Immersion</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>The immersion that is looked at</source>
        <translation>A imersão que se observa</translation>
    </message>
    <message>
        <source>Immersion %1</source>
        <translation>Imersão %1</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Enquadrar</translation>
    </message>
    <message>
        <source>Show the bodies as large as can be</source>
        <translation>Mostrar os corpos tão grandes quanto possível</translation>
    </message>
    <message>
        <source>Figures of both</source>
        <translation>Números de ambos</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progresso</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fechar</translation>
    </message>
    <message>
        <source>Back to the project; Escape does the same</source>
        <translation>De volta ao projeto; Escape faz o mesmo</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferença</translation>
    </message>
</context>
<context>
    <name>dipwright::DeeperFilm</name>
    <message>
        <source>Dipping deeper</source>
        <translation>Mergulhando mais fundo</translation>
    </message>
    <message>
        <source>Deeper dip</source>
        <translation>Imersão mais funda</translation>
    </message>
</context>
<context>
    <name>dipwright::DipCacheUpdater</name>
    <message>
        <source>Looking for results</source>
        <translation>Procurando resultados</translation>
    </message>
    <message>
        <source>The results are those of the dips kept beside the project.</source>
        <translation>Os resultados são os das imersões guardadas ao lado do projeto.</translation>
    </message>
</context>
<context>
    <name>dipwright::DipController</name>
    <message>
        <source>The Dip</source>
        <translation>A imersão</translation>
    </message>
    <message>
        <source>Simulated with %1 on %2</source>
        <translation>Simulado com %1 em %2</translation>
    </message>
    <message>
        <source>The sheet is out of date: it was made before the last changes.</source>
        <translation>A folha está desatualizada: foi feita antes das últimas mudanças.</translation>
    </message>
    <message>
        <source>The results are out of date: they were made before the last changes.</source>
        <translation>Os resultados estão desatualizados: foram feitos antes das últimas mudanças.</translation>
    </message>
    <message>
        <source>The results are out of date; run the dip again first.</source>
        <translation>Os resultados estão desatualizados; execute a imersão de novo antes.</translation>
    </message>
    <message>
        <source>Film %1</source>
        <translation>Filme %1</translation>
    </message>
</context>
<context>
    <name>dipwright::DipView</name>
    <message>
        <source>The 3D view needs OpenGL 3.2, and no such context could be made. Everything else works.</source>
        <translation>A vista 3D precisa de OpenGL 3.2, e não foi possível criar um contexto. Todo o resto funciona.</translation>
    </message>
</context>
<context>
    <name>dipwright::DistanceField</name>
    <message>
        <source>The distance field&apos;s resolution is %1; choose 32 to 512</source>
        <translation>A resolução do campo de distância é %1; escolha de 32 a 512</translation>
    </message>
    <message>
        <source>The body has no extent; choose a model with a surface</source>
        <translation>O corpo não tem extensão; escolha um modelo com superfície</translation>
    </message>
    <message>
        <source>Building the distance field</source>
        <translation>Construindo o campo de distância</translation>
    </message>
</context>
<context>
    <name>dipwright::Document</name>
    <message>
        <source>The project is open elsewhere (%1); choose another name</source>
        <translation>O projeto está aberto em outro lugar (%1); escolha outro nome</translation>
    </message>
</context>
<context>
    <name>dipwright::DocumentController</name>
    <message>
        <source>Open Project</source>
        <translation>Abrir projeto</translation>
    </message>
    <message>
        <source>Project in Use</source>
        <translation>Projeto em uso</translation>
    </message>
    <message>
        <source>“%1” is open already, on %2 (process %3).</source>
        <translation>“%1” já está aberto em %2 (processo %3).</translation>
    </message>
    <message>
        <source>an unknown machine</source>
        <translation>uma máquina desconhecida</translation>
    </message>
    <message>
        <source>Open Anyway</source>
        <translation>Abrir mesmo assim</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>Salvar projeto</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salvar</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Mudanças não salvas</translation>
    </message>
    <message>
        <source>Save the changes to “%1” before it is closed?</source>
        <translation>Salvar as mudanças em “%1” antes de fechar?</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Nenhum ainda</translation>
    </message>
    <message>
        <source>%1 is a picture: open the project first that is to wear it</source>
        <translation>%1 é uma imagem: abra antes o projeto que vai vesti-la</translation>
    </message>
    <message>
        <source>%1 is neither a project, a model nor a picture</source>
        <translation>%1 não é um projeto, nem um modelo, nem uma imagem</translation>
    </message>
    <message>
        <source>If both of you save, the second is asked whose work is to stay.</source>
        <translation>Se os dois salvarem, o segundo é perguntado qual trabalho fica.</translation>
    </message>
    <message>
        <source>Project Changed Elsewhere</source>
        <translation>Projeto mudado em outro lugar</translation>
    </message>
    <message>
        <source>Another program has written “%1” since it was opened here.</source>
        <translation>Outro programa gravou “%1” desde que foi aberto aqui.</translation>
    </message>
    <message>
        <source>Save under another name to keep both. Overwriting loses what the other has done.</source>
        <translation>Salve com outro nome para guardar os dois. Sobrescrever perde o que o outro fez.</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Salvar &amp;como…</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>&amp;Sobrescrever</translation>
    </message>
</context>
<context>
    <name>dipwright::DocumentSession</name>
    <message>
        <source>Opening the project</source>
        <translation>Abrindo o projeto</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>Abrir projeto</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 aberto</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>Novo projeto</translation>
    </message>
    <message>
        <source>Restoring the project</source>
        <translation>Restaurando o projeto</translation>
    </message>
    <message>
        <source>Restore Project</source>
        <translation>Restaurar projeto</translation>
    </message>
    <message>
        <source>Restored unsaved changes of %1</source>
        <translation>Mudanças não salvas de %1 restauradas</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 salvo</translation>
    </message>
    <message>
        <source>Unsaved changes are not kept in case of a crash; save them often. %1</source>
        <translation>As alterações não salvas não são guardadas para o caso de uma falha; salve com frequência. %1</translation>
    </message>
</context>
<context>
    <name>dipwright::DrawnPage</name>
    <message>
        <source>The page cannot be written: %1</source>
        <translation>A página não pode ser escrita: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::EditController</name>
    <message>
        <source>Replace Model</source>
        <translation>Trocar modelo</translation>
    </message>
    <message>
        <source>Replace Texture</source>
        <translation>Trocar textura</translation>
    </message>
</context>
<context>
    <name>dipwright::ExportController</name>
    <message>
        <source>Export Results to a Folder</source>
        <translation>Exportar resultados para uma pasta</translation>
    </message>
    <message>
        <source>Export Results</source>
        <translation>Exportar resultados</translation>
    </message>
    <message>
        <source>Wrote the results to %1</source>
        <translation>Resultados gravados em %1</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 gravado</translation>
    </message>
    <message>
        <source>Save Sheet</source>
        <translation>Salvar folha</translation>
    </message>
    <message>
        <source>Export Stretch</source>
        <translation>Exportar estiramento</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>estiramento</translation>
    </message>
    <message>
        <source>These sheets were made before the last changes. Run the dip first to print what the project now says.</source>
        <translation>Estas folhas foram feitas antes das últimas mudanças. Execute a imersão antes, para imprimir o que o projeto diz agora.</translation>
    </message>
    <message>
        <source>Save Maps</source>
        <translation>Salvar mapas</translation>
    </message>
    <message>
        <source>Wrote the maps to %1</source>
        <translation>Mapas gravados em %1</translation>
    </message>
    <message>
        <source>Export Cradles</source>
        <translation>Exportar berços</translation>
    </message>
    <message>
        <source>Export Cradles to a Folder</source>
        <translation>Exportar berços para uma pasta</translation>
    </message>
    <message>
        <source>Wrote the cradles to %1</source>
        <translation>Berços gravados em %1</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmFit</name>
    <message>
        <source>The fit does not come to rest in %1 rounds; look for places that were mistaken for others, or fit fewer quantities</source>
        <translation>O ajuste não se estabiliza em %1 rodadas; procure pontos confundidos com outros ou ajuste menos grandezas</translation>
    </message>
    <message>
        <source>Fitted</source>
        <translation>Ajustado</translation>
    </message>
    <message>
        <source>The pairs tell nothing of the film; give more of them, all round the body</source>
        <translation>Os pares não dizem nada do filme; dê mais deles, ao redor de todo o corpo</translation>
    </message>
    <message>
        <source>None of the printed places lies on the body in the simulation; are they of this job&apos;s sheet?</source>
        <translation>Nenhum dos pontos impressos fica sobre o corpo na simulação; eles são da folha deste trabalho?</translation>
    </message>
    <message>
        <source>%1, dip %2</source>
        <translation>%1, imersão %2</translation>
    </message>
    <message>
        <source>%1 and %2 are told together rather than each by itself: correlation %3</source>
        <translation>%1 e %2 são determinados juntos e não cada um por si: correlação %3</translation>
    </message>
    <message>
        <source>%1 is not told by these pairs and stays as it was</source>
        <translation>%1 não é determinado por estes pares e fica como estava</translation>
    </message>
    <message>
        <source>The print was off by %1 px or %2 mm and is by %3 px or %4 mm with what was found (root mean square)</source>
        <translation>A impressão estava fora por %1 px ou %2 mm e fica fora por %3 px ou %4 mm com o que foi encontrado (valor quadrático médio)</translation>
    </message>
    <message>
        <source>give pairs of places all round the body</source>
        <translation>dê pares de pontos ao redor de todo o corpo</translation>
    </message>
    <message>
        <source>photograph places near the body&apos;s lowest point and others high on its sides, from more than one direction</source>
        <translation>fotografe pontos perto do ponto mais baixo do corpo e outros no alto dos lados, de mais de uma direção</translation>
    </message>
    <message>
        <source>measure growth by photos of the floating film, “inspect film”</source>
        <translation>meça o crescimento por fotos do filme flutuando, “inspect film”</translation>
    </message>
    <message>
        <source>measure it at the tank and leave it out of the fit</source>
        <translation>meça no tanque e deixe fora do ajuste</translation>
    </message>
    <message>
        <source>The project&apos;s film does not grow, and so its growth cannot be fitted; measure it by photos of the floating film, “inspect film”</source>
        <translation>O filme do projeto não cresce, e por isso seu crescimento não pode ser ajustado; meça-o por fotos do filme flutuando, “inspect film”</translation>
    </message>
    <message>
        <source>%1 changes nothing of this film and cannot be fitted</source>
        <translation>%1 não muda nada neste filme e não pode ser ajustado</translation>
    </message>
    <message>
        <source>%1 moves none of the places, so that the pairs do not tell it; %2</source>
        <translation>%1 não move nenhum dos pontos, de modo que os pares não o determinam; %2</translation>
    </message>
    <message>
        <source>The pairs cannot tell %1 from the camera&apos;s place (correlation %2); %3</source>
        <translation>Os pares não distinguem %1 do lugar da câmera (correlação %2); %3</translation>
    </message>
    <message>
        <source>give more pairs of the body itself, farther apart</source>
        <translation>dê mais pares do próprio corpo, mais afastados</translation>
    </message>
    <message>
        <source>give pairs of the body itself, its edges, corners or holes, with --pairs</source>
        <translation>dê pares do próprio corpo, suas arestas, cantos ou furos, com --pairs</translation>
    </message>
    <message>
        <source>The pairs cannot tell %1 from %2 (correlation %3); fit one of the two alone, or %4</source>
        <translation>Os pares não distinguem %1 de %2 (correlação %3); ajuste só um dos dois, ou %4</translation>
    </message>
    <message>
        <source>The pairs do not tell %1 well enough; give more of them, or %2</source>
        <translation>Os pares não determinam %1 bem o bastante; dê mais deles, ou %2</translation>
    </message>
    <message>
        <source>Body along X</source>
        <translation>Corpo ao longo de X</translation>
    </message>
    <message>
        <source>Body along Z</source>
        <translation>Corpo ao longo de Z</translation>
    </message>
    <message>
        <source>Body about Y</source>
        <translation>Corpo em torno de Y</translation>
    </message>
    <message>
        <source>Swell along X</source>
        <translation>Inchamento ao longo de X</translation>
    </message>
    <message>
        <source>Swell along Y</source>
        <translation>Inchamento ao longo de Y</translation>
    </message>
    <message>
        <source>Relaxation</source>
        <translation>Relaxação</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Crescimento</translation>
    </message>
    <message>
        <source>Contact distance</source>
        <translation>Distância de contato</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidade</translation>
    </message>
    <message>
        <source>“%1” is nothing that can be fitted; choose of %2</source>
        <translation>“%1” não pode ser ajustado; escolha entre %2</translation>
    </message>
    <message>
        <source>There are fewer pairs on the body than tell %1 numbers of film and camera; give more, or fit fewer quantities</source>
        <translation>Há menos pares no corpo do que os que determinam %1 números de filme e câmera; dê mais ou ajuste menos grandezas</translation>
    </message>
    <message>
        <source>No film and camera are found that fit the pairs; look for places that were mistaken for others</source>
        <translation>Não se encontram filme e câmera que combinem com os pares; procure pontos confundidos com outros</translation>
    </message>
    <message>
        <source>A place is said to be of dip %1, and the project has %2</source>
        <translation>Um ponto seria da imersão %1, e o projeto tem %2</translation>
    </message>
    <message>
        <source>%1: %2, was taken for %3; 95 %: %4</source>
        <translation>%1: %2, supunha-se %3; 95 %: %4</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>%1 is known to about %2 % only: a tenth of it moves none of the places seen by more than %3 mm; give more of them, or %4</source>
        <translation>%1 só se conhece a cerca de %2 %: um décimo não move nenhum dos lugares vistos mais de %3 mm; dê mais deles, ou %4</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmPage</name>
    <message>
        <source>Unevenness of the film</source>
        <translation>Irregularidade do filme</translation>
    </message>
    <message>
        <source>Where the film has grown more and less is shown here.</source>
        <translation>Aqui se mostra onde o filme cresceu mais e onde cresceu menos.</translation>
    </message>
    <message>
        <source>Photos of the film</source>
        <translation>Fotos do filme</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Seconds since it was laid</source>
        <translation>Segundos desde que foi posto</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>não medida</translation>
    </message>
    <message>
        <source> °C</source>
        <translation> °C</translation>
    </message>
    <message>
        <source>Add photos of the film&apos;s chessboard floating on the water with the card beside it, or drop them here. The guide says how they are made.</source>
        <translation>Adicione fotos do tabuleiro do filme flutuando na água com o cartão ao lado, ou solte-as aqui. O guia diz como são feitas.</translation>
    </message>
    <message>
        <source>Dip begins after</source>
        <translation>O mergulho começa após</translation>
    </message>
    <message>
        <source>Lot</source>
        <translation>Lote</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Água</translation>
    </message>
    <message>
        <source>Add &amp;Photos…</source>
        <translation>Adicionar &amp;fotos…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Remover</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Medir</translation>
    </message>
    <message>
        <source>&amp;Save to Profile…</source>
        <translation>&amp;Salvar no perfil…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>Photos of the Film</source>
        <translation>Fotos do filme</translation>
    </message>
    <message>
        <source>Photos (%1)</source>
        <translation>Fotos (%1)</translation>
    </message>
    <message>
        <source>Seconds since the film was laid on the water</source>
        <translation>Segundos desde que o filme foi posto na água</translation>
    </message>
    <message>
        <source>when the dip begins</source>
        <translation>no início do mergulho</translation>
    </message>
    <message>
        <source>Photo of the film</source>
        <translation>Foto do filme</translation>
    </message>
    <message>
        <source>The corners that were found in the photo are shown here.</source>
        <translation>Os cantos encontrados na foto são mostrados aqui.</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Cantos</translation>
    </message>
    <message>
        <source>Unevenness</source>
        <translation>Irregularidade</translation>
    </message>
    <message>
        <source>Seconds since the film was laid on the water; the swell is told of then</source>
        <translation>Segundos desde que o filme foi posto na água; o inchaço vale para esse momento</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Na largura</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Na altura</translation>
    </message>
    <message>
        <source>How exactly each ruler was read; the swell&apos;s interval holds it</source>
        <translation>Com que exatidão cada régua foi lida; o intervalo do inchaço inclui isso</translation>
    </message>
    <message>
        <source>as the photos say</source>
        <translation>como dizem as fotos</translation>
    </message>
    <message>
        <source>Of a camera of 35 mm; only needed where the card lies above the film</source>
        <translation>Como em uma câmera de 35 mm; só é necessária quando o cartão fica acima do filme</translation>
    </message>
    <message>
        <source>Card&apos;s rulers</source>
        <translation>Réguas do cartão</translation>
    </message>
    <message>
        <source>Dry film&apos;s rulers</source>
        <translation>Réguas do filme seco</translation>
    </message>
    <message>
        <source>Read to ±</source>
        <translation>Lidas a ±</translation>
    </message>
    <message>
        <source>Card above the film</source>
        <translation>Cartão acima do filme</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Distância focal</translation>
    </message>
    <message>
        <source>Distortion</source>
        <translation>Distorção</translation>
    </message>
    <message>
        <source>Rulers and Camera</source>
        <translation>Réguas e câmera</translation>
    </message>
    <message>
        <source>What the printed rulers measure, how high the card lies, and what is known of the camera</source>
        <translation>O que as réguas impressas medem, a que altura fica o cartão e o que se sabe da câmera</translation>
    </message>
    <message>
        <source>%1: %2 corners of the film, %3 of the card, %4 px off</source>
        <translation>%1: %2 cantos do filme, %3 do cartão, desvio de %4 px</translation>
    </message>
    <message>
        <source>k1 ?</source>
        <translation>k1 ?</translation>
    </message>
    <message>
        <source>k2 ?</source>
        <translation>k2 ?</translation>
    </message>
    <message>
        <source>Of a camera measured before; “?”: as each photo has it</source>
        <translation>De uma câmera medida antes; “?”: como em cada foto</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmProbe</name>
    <message>
        <source>Body at %1, %2, %3</source>
        <translation>Corpo em %1, %2, %3</translation>
    </message>
    <message>
        <source>on the body</source>
        <translation>no corpo</translation>
    </message>
    <message>
        <source>on the water</source>
        <translation>na água</translation>
    </message>
    <message>
        <source>Sheet %1, %2 · %3 · stretch %4 by %5, area %6</source>
        <translation>Folha %1, %2 · %3 · estiramento %4 por %5, área %6</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmWatch</name>
    <message>
        <source>The film&apos;s chessboard is mirrored: lay the film with its ink side up, or turn the picture back that was flipped</source>
        <translation>O tabuleiro do filme está espelhado: deite o filme com a tinta para cima, ou desvire a imagem que foi espelhada</translation>
    </message>
    <message>
        <source>The card is mirrored: turn the picture back that was flipped</source>
        <translation>O cartão está espelhado: desvire a imagem que foi espelhada</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>Growth is not measured: that takes photos at three moments or more, from before the dip begins to after it ends</source>
        <translation>O crescimento não está medido: para isso são precisas fotos em três momentos ou mais, de antes do início da imersão até depois do fim</translation>
    </message>
    <message>
        <source>The film did not grow between the photos by more than they can tell</source>
        <translation>O filme não cresceu entre as fotos mais do que elas podem mostrar</translation>
    </message>
    <message>
        <source>Growth: %1 ± %2 % a second</source>
        <translation>Crescimento: %1 ± %2 % por segundo</translation>
    </message>
    <message>
        <source>It still grew as fast at the last photo, so that its limit is not known and the profile keeps its own growth; go on until it grows no more</source>
        <translation>Na última foto ele ainda crescia tão depressa que o limite não é conhecido e o perfil mantém o seu próprio crescimento; continue até que não cresça mais</translation>
    </message>
    <message>
        <source>Growth: %1 ± %2 % a second when the dip begins, by %3 ± %4 % in the end</source>
        <translation>Crescimento: %1 ± %2 % por segundo no início da imersão, no fim %3 ± %4 %</translation>
    </message>
    <message>
        <source>Of the film&apos;s chessboard too little is seen; photograph all of it, sharp and without glare</source>
        <translation>Do tabuleiro do filme vê-se muito pouco; fotografe-o inteiro, nítido e sem reflexos</translation>
    </message>
    <message>
        <source>No chessboard of the film watch is seen; print it with “calibrate film” and photograph it whole, sharp and without glare</source>
        <translation>Não se vê nenhum tabuleiro da medição do filme; imprima-o com “calibrate film” e fotografe-o inteiro, nítido e sem reflexos</translation>
    </message>
    <message>
        <source>The card of the film watch is not seen, without which no lengths are known; print it with “calibrate card” and lay it beside the film</source>
        <translation>Não se vê o cartão da medição do filme, sem o qual nenhum comprimento é conhecido; imprima-o com “calibrate card” e deite-o ao lado do filme</translation>
    </message>
    <message>
        <source>Swell when the dip begins: along X %1, along Y %2</source>
        <translation>Inchamento no início da imersão: ao longo de X %1, ao longo de Y %2</translation>
    </message>
    <message>
        <source>Unevenness: 95 % of the film lies within %1 mm of where an evenly swollen film would lie</source>
        <translation>Irregularidade: 95 % do filme fica a no máximo %1 mm de onde estaria um filme inchado por igual</translation>
    </message>
    <message>
        <source>Unevenness of the film</source>
        <translation>Irregularidade do filme</translation>
    </message>
    <message>
        <source>Colour: grown more or less than the mean, %1 · arrows: moved, %2 times</source>
        <translation>Cor: cresceu mais ou menos que a média, %1 · setas: deslocado, %2 vezes</translation>
    </message>
    <message>
        <source>95 % of the corners lie within %1 mm of an evenly swollen film</source>
        <translation>95 % dos cantos ficam a no máximo %1 mm de um filme inchado por igual</translation>
    </message>
    <message>
        <source>The corners seen do not tell how the film lies; photograph film and card from above, both whole</source>
        <translation>Os cantos vistos não dizem como o filme está deitado; fotografe filme e cartão de cima, ambos inteiros</translation>
    </message>
    <message>
        <source>Only %1 corners of the film&apos;s chessboard are seen and it takes %2; photograph all of it, without glare</source>
        <translation>Só se veem %1 cantos do tabuleiro do filme e são precisos %2; fotografe-o inteiro, sem reflexos</translation>
    </message>
    <message>
        <source>Only %1 corners of the card are seen and it takes %2; photograph all of it, without glare</source>
        <translation>Só se veem %1 cantos do cartão e são precisos %2; fotografe-o inteiro, sem reflexos</translation>
    </message>
    <message>
        <source>The photo does not say how long the camera&apos;s lens was, which is needed where the card lies above the film; give its focal length as of a 35 mm camera</source>
        <translation>A foto não diz a distância focal da câmera, necessária quando o cartão fica acima do filme; informe-a como em uma câmera de 35 mm</translation>
    </message>
    <message>
        <source>The photos show the film from %1 to %2 s after it was laid on the water, and the dip begins after %3 s, of which they tell nothing; correct the times, or photograph the film from before the dip begins</source>
        <translation>As fotos mostram o filme de %1 a %2 s depois de posto na água, e a imersão começa após %3 s, sobre o que elas nada dizem; corrija os tempos, ou fotografe o filme desde antes de a imersão começar</translation>
    </message>
    <message>
        <source>The swell is that after %1 s, and the dip begins after %2 s: what the film grows between is not in it</source>
        <translation>O inchamento é o de %1 s, e a imersão começa após %2 s: o que o filme cresce entre os dois não está nele</translation>
    </message>
    <message>
        <source>The card&apos;s corners lie %1 px from where those of a flat card would; lay it flat, and correct what is told of the lens&apos;s distortion, the focal length and the card&apos;s height, or leave them out</source>
        <translation>Os cantos do cartão estão a %1 px de onde estariam os de um cartão plano; deite-o plano, e corrija o que se diz da distorção da lente, da distância focal e da altura do cartão, ou deixe isso de fora</translation>
    </message>
</context>
<context>
    <name>dipwright::FilmWatchController</name>
    <message>
        <source>Reading photos</source>
        <translation>Lendo fotos</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>The project names photos outside itself:</source>
        <translation>O projeto indica fotos fora dele:</translation>
    </message>
    <message>
        <source>Measuring the film</source>
        <translation>Medindo o filme</translation>
    </message>
    <message>
        <source>Film on the Water</source>
        <translation>Filme na água</translation>
    </message>
    <message>
        <source>The photo %1 is another one than was added.</source>
        <translation>A foto %1 é outra que não a adicionada.</translation>
    </message>
    <message>
        <source>Export Film Watch to a Folder</source>
        <translation>Exportar observação do filme para uma pasta</translation>
    </message>
    <message>
        <source>Export Film Watch</source>
        <translation>Exportar observação do filme</translation>
    </message>
    <message>
        <source>Wrote the film watch to %1</source>
        <translation>Observação do filme gravada em %1</translation>
    </message>
</context>
<context>
    <name>dipwright::FitController</name>
    <message>
        <source>Fitting film and dip</source>
        <translation>Ajustando filme e imersão</translation>
    </message>
    <message>
        <source>Use in Project</source>
        <translation>Usar no projeto</translation>
    </message>
    <message>
        <source>Export Fit to a Folder</source>
        <translation>Exportar ajuste para uma pasta</translation>
    </message>
    <message>
        <source>Export Fit</source>
        <translation>Exportar ajuste</translation>
    </message>
    <message>
        <source>Wrote the fit to %1</source>
        <translation>Ajuste gravado em %1</translation>
    </message>
</context>
<context>
    <name>dipwright::FitPage</name>
    <message>
        <source>What was fitted</source>
        <translation>O que foi ajustado</translation>
    </message>
    <message>
        <source>Correlations of what was fitted</source>
        <translation>Correlações do que foi ajustado</translation>
    </message>
    <message>
        <source>Near 1 or −1: the two are told together rather than each by itself</source>
        <translation>Perto de 1 ou −1: os dois são conhecidos mais em conjunto do que cada um por si</translation>
    </message>
    <message>
        <source>&amp;Fit Film and Dip</source>
        <translation>&amp;Ajustar filme e imersão</translation>
    </message>
    <message>
        <source>Finds what film and dip really were: simulates the dip again and again until the print lies where the photos show it</source>
        <translation>Encontra como foram de fato o filme e a imersão: simula repetidas vezes até a impressão ficar onde as fotos a mostram</translation>
    </message>
    <message>
        <source>&amp;Use in Project</source>
        <translation>&amp;Usar no projeto</translation>
    </message>
    <message>
        <source>The project takes film, placement and depth as they were found; the film counts as measured</source>
        <translation>O projeto assume filme, posição e profundidade como encontrados; o filme conta como medido</translation>
    </message>
    <message>
        <source>&amp;Save to Profile…</source>
        <translation>&amp;Salvar no perfil…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Encontrado</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Correlation</source>
        <translation>Correlação</translation>
    </message>
    <message>
        <source>Find the corners of the print on the page “Dipped Part” first: film and dip are fitted to them.</source>
        <translation>Procure primeiro os cantos da impressão na página “Peça mergulhada”: filme e imersão são ajustados a eles.</translation>
    </message>
    <message>
        <source>The pairs are not of the body itself: a shift or turn of the whole print cannot be told from one of the camera.</source>
        <translation>Os pares não são do próprio corpo: um deslocamento ou giro de toda a impressão não se distingue de um da câmera.</translation>
    </message>
    <message>
        <source>Fits placement, swell and relaxation, as far as the photos tell them.</source>
        <translation>Ajusta posição, inchamento e relaxação, até onde as fotos os mostram.</translation>
    </message>
    <message>
        <source>The project has film, placement and depth as they were found here. To fit again, find the corners anew.</source>
        <translation>O projeto tem filme, posição e profundidade como foram achados aqui. Para ajustar outra vez, procure os cantos de novo.</translation>
    </message>
</context>
<context>
    <name>dipwright::GuidePictures</name>
    <message>
        <source>film.pdf
printed on the film</source>
        <translation>film.pdf
impresso no filme</translation>
    </message>
    <message>
        <source>card.pdf
printed on stiff, waterproof card</source>
        <translation>card.pdf
impresso em cartão rígido e impermeável</translation>
    </message>
    <message>
        <source>The rulers of both must measure 100 mm</source>
        <translation>As réguas dos dois devem medir 100 mm</translation>
    </message>
    <message>
        <source>The film, its ink side up, as for a dip</source>
        <translation>O filme, tinta para cima, como para a imersão</translation>
    </message>
    <message>
        <source>The card beside it, flat</source>
        <translation>O cartão ao lado, plano</translation>
    </message>
    <message>
        <source>Both prints at one height: that is how millimetres are known</source>
        <translation>As duas impressões à mesma altura: daí se conhecem os milímetros</translation>
    </message>
    <message>
        <source>Note the time when the film is laid</source>
        <translation>Anote a hora em que o filme é posto</translation>
    </message>
    <message>
        <source>From above, both whole, no glare</source>
        <translation>De cima, os dois inteiros, sem reflexo</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>One photo tells the swell, three or more the growth</source>
        <translation>Uma foto mostra o inchamento; três ou mais, o crescimento</translation>
    </message>
    <message>
        <source>from before the dip begins until the film grows no more</source>
        <translation>de antes da imersão até o filme não crescer mais</translation>
    </message>
</context>
<context>
    <name>dipwright::GuideWindow</name>
    <message>
        <source>User Guide</source>
        <translation>Guia do usuário</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Conteúdo</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Buscar no guia</translation>
    </message>
    <message>
        <source>Enter goes to the next place</source>
        <translation>Enter vai ao próximo lugar</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Nada encontrado</translation>
    </message>
    <message>
        <source>Places: %1</source>
        <translation>Lugares: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::HelpController</name>
    <message>
        <source>Welcome</source>
        <translation>Bem-vindo</translation>
    </message>
    <message>
        <source>Dipwright computes the picture to print on a film so that, when the body is dipped through it, every colour lands where it belongs.</source>
        <translation>O Dipwright calcula a imagem a imprimir em um filme para que, ao mergulhar o corpo, cada cor caia onde deve.</translation>
    </message>
    <message>
        <source>The project</source>
        <translation>O projeto</translation>
    </message>
    <message>
        <source>Model, film, one or two immersions, sheet and ink. Choose a part in the tree and change its values below. Begin by dropping a model on the window.</source>
        <translation>Modelo, filme, uma ou duas imersões, folha e tinta. Escolha uma parte na árvore e mude seus valores abaixo. Comece soltando um modelo na janela.</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>A vista</translation>
    </message>
    <message>
        <source>The body above the film. Drag to look round it, turn it by its rings, then press Run.</source>
        <translation>O corpo acima do filme. Arraste para olhar em volta, gire-o pelos anéis e aperte Executar.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Executar</translation>
    </message>
    <message>
        <source>Simulates the dip while you watch and can be cancelled at any time. With Run Live, each change runs what depends on it again.</source>
        <translation>Simula a imersão diante de você e pode ser cancelado a qualquer momento. Com Executar ao vivo, cada mudança recalcula o que depende dela.</translation>
    </message>
    <message>
        <source>The timeline</source>
        <translation>A linha do tempo</translation>
    </message>
    <message>
        <source>Plays the dip again, or shows any moment of it.</source>
        <translation>Reproduz a imersão de novo ou mostra qualquer momento dela.</translation>
    </message>
    <message>
        <source>The results</source>
        <translation>Os resultados</translation>
    </message>
    <message>
        <source>How the film stretches, the picture that goes on it, the body as it will come out, and the sheet to print. Move the cursor over one and see the same place in all the others.</source>
        <translation>Como o filme estica, a imagem que vai nele, o corpo como sairá e a folha a imprimir. Passe o cursor sobre um e veja o mesmo lugar em todos os outros.</translation>
    </message>
    <message>
        <source>About Dipwright</source>
        <translation>Sobre o Dipwright</translation>
    </message>
    <message>
        <source>Computational hydrographic printing.</source>
        <translation>Impressão hidrográfica computacional.</translation>
    </message>
    <message>
        <source>The report is on the clipboard</source>
        <translation>O relatório está na área de transferência</translation>
    </message>
</context>
<context>
    <name>dipwright::Histogram</name>
    <message>
        <source>Histogram</source>
        <translation>Histograma</translation>
    </message>
</context>
<context>
    <name>dipwright::ImportModel</name>
    <message>
        <source>there is no number where one should be, in line %1</source>
        <translation>não há número onde deveria haver, na linha %1</translation>
    </message>
    <message>
        <source>it counts more values than it can hold, in line %1</source>
        <translation>ele conta mais valores do que pode conter, na linha %1</translation>
    </message>
    <message>
        <source>its array %1 has fewer values than are read</source>
        <translation>sua lista %1 tem menos valores do que se leem</translation>
    </message>
    <message>
        <source>Reading the model</source>
        <translation>Lendo o modelo</translation>
    </message>
    <message>
        <source>The model&apos;s size must be more than 0 and at most %1 mm</source>
        <translation>O tamanho do modelo deve ser maior que 0 e no máximo %1 mm</translation>
    </message>
    <message>
        <source>The model&apos;s unit must be a positive number of millimetres</source>
        <translation>A unidade do modelo deve ser um número positivo de milímetros</translation>
    </message>
    <message>
        <source>The model file does not exist; check its name</source>
        <translation>O arquivo do modelo não existe; confira o nome</translation>
    </message>
    <message>
        <source>This is a folder; choose a model file in it</source>
        <translation>Isto é uma pasta; escolha um arquivo de modelo nela</translation>
    </message>
    <message>
        <source>The model file cannot be read; check its permissions</source>
        <translation>O arquivo do modelo não pode ser lido; confira as permissões</translation>
    </message>
    <message>
        <source>The model file is empty; save it anew</source>
        <translation>O arquivo do modelo está vazio; salve-o de novo</translation>
    </message>
    <message>
        <source>The texture file cannot be read; check its name and permissions</source>
        <translation>O arquivo de textura não pode ser lido; confira o nome e as permissões</translation>
    </message>
    <message>
        <source>%1 corners of the model&apos;s triangles are not numbers (NaN or infinite); repair the model and save it anew</source>
        <translation>%1 vértices dos triângulos do modelo não são números (NaN ou infinito); repare o modelo e salve-o de novo</translation>
    </message>
    <message>
        <source>None of the model&apos;s triangles has an area; choose another model</source>
        <translation>Nenhum triângulo do modelo tem área; escolha outro modelo</translation>
    </message>
    <message>
        <source>The model has no extent; choose another model</source>
        <translation>O modelo não tem extensão; escolha outro modelo</translation>
    </message>
    <message>
        <source>The model&apos;s longest edge would be %1 mm; give the size it is to have</source>
        <translation>A aresta mais longa do modelo teria %1 mm; informe o tamanho desejado</translation>
    </message>
    <message>
        <source>The model lies too far from its origin; move it there and save it anew</source>
        <translation>O modelo está longe demais da origem; mova-o para lá e salve de novo</translation>
    </message>
    <message>
        <source>The mesh is not closed: what is inside is judged by most of the directions from which it is seen</source>
        <translation>A malha não é fechada: o interior é julgado pela maioria das direções de visão</translation>
    </message>
    <message>
        <source>The model&apos;s longest edge is only %1 mm; if its file is not in millimetres, give the size it is to have</source>
        <translation>A aresta mais longa do modelo tem só %1 mm; se o arquivo não estiver em milímetros, informe o tamanho desejado</translation>
    </message>
    <message>
        <source>The model has no texture coordinates, so its texture cannot be placed and is not used; its materials&apos; colours are</source>
        <translation>O modelo não tem coordenadas de textura, então a textura não pode ser aplicada; usam-se as cores dos materiais</translation>
    </message>
    <message>
        <source>The file %1, which the model names, was not found</source>
        <translation>O arquivo %1, citado pelo modelo, não foi encontrado</translation>
    </message>
    <message>
        <source>%1 texture coordinates are too large to be used; their triangles show the material&apos;s colour</source>
        <translation>%1 coordenadas de textura são grandes demais; seus triângulos mostram a cor do material</translation>
    </message>
    <message>
        <source>The model has no triangles; save it with its surface</source>
        <translation>O modelo não tem triângulos; salve-o com a superfície</translation>
    </message>
    <message>
        <source>Checking the model</source>
        <translation>Verificando o modelo</translation>
    </message>
    <message>
        <source>Finding the texture&apos;s charts</source>
        <translation>Localizando as partes da textura</translation>
    </message>
    <message>
        <source>The model needs more memory than there is; reduce it</source>
        <translation>O modelo precisa de mais memória do que há; reduza-o</translation>
    </message>
    <message>
        <source>The texture %1 was not found beside the model; its material&apos;s colour is used instead</source>
        <translation>A textura %1 não foi encontrada ao lado do modelo; usa-se a cor do material</translation>
    </message>
    <message>
        <source>it ends too early</source>
        <translation>termina cedo demais</translation>
    </message>
    <message>
        <source>there is a word where a number should be</source>
        <translation>há uma palavra onde deveria haver um número</translation>
    </message>
    <message>
        <source>it is not a PLY file</source>
        <translation>não é um arquivo PLY</translation>
    </message>
    <message>
        <source>its PLY format %1 is unknown</source>
        <translation>seu formato PLY %1 é desconhecido</translation>
    </message>
    <message>
        <source>its header is not understood</source>
        <translation>seu cabeçalho não é compreendido</translation>
    </message>
    <message>
        <source>its points have no x, y and z</source>
        <translation>seus pontos não têm x, y e z</translation>
    </message>
    <message>
        <source>its faces have no corners</source>
        <translation>suas faces não têm vértices</translation>
    </message>
    <message>
        <source>a face names a point that is not there</source>
        <translation>uma face cita um ponto que não existe</translation>
    </message>
    <message>
        <source>The colours of the model&apos;s points are not used; bake them into a texture to print them</source>
        <translation>As cores dos pontos do modelo não são usadas; grave-as em uma textura para imprimi-las</translation>
    </message>
    <message>
        <source>texture %1 in %2</source>
        <translation>textura %1 em %2</translation>
    </message>
    <message>
        <source>Reading triangles</source>
        <translation>Lendo triângulos</translation>
    </message>
    <message>
        <source>a triangle names a point that is not there</source>
        <translation>um triângulo cita um ponto que não existe</translation>
    </message>
    <message>
        <source>it is not a 3MF package</source>
        <translation>não é um pacote 3MF</translation>
    </message>
    <message>
        <source>%1 in it is damaged</source>
        <translation>%1 nele está danificado</translation>
    </message>
    <message>
        <source>%1 in it: %2</source>
        <translation>%1 nele: %2</translation>
    </message>
    <message>
        <source>its elements are out of order</source>
        <translation>seus elementos estão fora de ordem</translation>
    </message>
    <message>
        <source>there is no number where one should be</source>
        <translation>falta um número onde deveria haver</translation>
    </message>
    <message>
        <source>%1 is not in it</source>
        <translation>%1 não está nele</translation>
    </message>
    <message>
        <source>it places an object that is not there</source>
        <translation>posiciona um objeto que não existe</translation>
    </message>
    <message>
        <source>The texture %1 is not in the model&apos;s package; its material&apos;s colour is used instead</source>
        <translation>A textura %1 não está no pacote do modelo; usa-se a cor do material</translation>
    </message>
    <message>
        <source>The model has no texture coordinates, so no picture can be placed on it; unwrap it in a modelling program first</source>
        <translation>O modelo não tem coordenadas de textura, portanto nenhuma imagem pode ser posta nele; planifique-o antes em um programa de modelagem</translation>
    </message>
    <message>
        <source>The model cannot be read: %1; save it anew, or as %2</source>
        <translation>O modelo não pode ser lido: %1; salve-o de novo ou como %2</translation>
    </message>
    <message>
        <source>its format is none of those that are read</source>
        <translation>seu formato não é nenhum dos que são lidos</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>o arquivo não pode ser aberto</translation>
    </message>
    <message>
        <source>%1 describes a material before it names any</source>
        <translation>%1 descreve um material antes de nomear algum</translation>
    </message>
    <message>
        <source>%1 in it is encrypted</source>
        <translation>%1 nele está criptografado</translation>
    </message>
    <message>
        <source>The model names files that do not belong to its folder, such as %1, and is not read; put them beside it, or allow it to read them (--allow-outside)</source>
        <translation>O modelo cita arquivos que não pertencem à sua pasta, como %1, e não é lido; coloque-os ao lado dele ou permita que sejam lidos (--allow-outside)</translation>
    </message>
    <message>
        <source>Triangles without area that were removed: %1</source>
        <translation>Triângulos sem área que foram removidos: %1</translation>
    </message>
    <message>
        <source>Triangles turned that faced the other way than their neighbours: %1</source>
        <translation>Triângulos virados que estavam ao contrário dos vizinhos: %1</translation>
    </message>
    <message>
        <source>Parts of the surface turned that were inside out: %1</source>
        <translation>Partes da superfície viradas que estavam do avesso: %1</translation>
    </message>
    <message>
        <source>it needs the glTF extension %1, which is not read (export it without that)</source>
        <translation>ele precisa da extensão glTF %1, que não é lida (exporte-o sem ela)</translation>
    </message>
    <message>
        <source>its points or texture coordinates are whole numbers, which are not read (export it with float coordinates, without quantization)</source>
        <translation>seus pontos ou coordenadas de textura são números inteiros, que não são lidos (exporte-o com coordenadas de ponto flutuante, sem quantização)</translation>
    </message>
    <message>
        <source>The model scales or turns a texture (KHR_texture_transform), which is not followed rightly; apply that to the texture coordinates in a modelling program</source>
        <translation>O modelo escala ou gira uma textura (KHR_texture_transform), o que não é seguido corretamente; aplique isso às coordenadas de textura em um programa de modelagem</translation>
    </message>
    <message>
        <source>A texture of the model is without a picture or in a format that is not read, and its material&apos;s colour is used instead; export it with PNG or JPEG</source>
        <translation>Uma textura do modelo está sem imagem ou em um formato que não é lido, e a cor do seu material é usada no lugar; exporte-o com PNG ou JPEG</translation>
    </message>
    <message>
        <source>it holds more than its header counts</source>
        <translation>contém mais do que seu cabeçalho conta</translation>
    </message>
    <message>
        <source>its unit %1 is unknown</source>
        <translation>sua unidade %1 é desconhecida</translation>
    </message>
    <message>
        <source>it needs the 3MF extension %1, which is not read</source>
        <translation>precisa da extensão 3MF %1, que não é lida</translation>
    </message>
    <message>
        <source>two things in it have the number %1</source>
        <translation>duas coisas nele têm o número %1</translation>
    </message>
    <message>
        <source>it names a material or texture that is not there</source>
        <translation>cita um material ou uma textura que não existe</translation>
    </message>
    <message>
        <source>a transform in it is not twelve numbers</source>
        <translation>uma transformação nele não é formada por doze números</translation>
    </message>
    <message>
        <source>Options that %1 gives a texture are not followed: %2; apply them to the picture in a modelling program</source>
        <translation>Opções que %1 dá a uma textura não são seguidas: %2; aplique-as à imagem em um programa de modelagem</translation>
    </message>
    <message>
        <source>The model has a skin without bind matrices: its points are taken as they are stored, not as the joints place them; where they lie wrong, apply the armature in a modelling program</source>
        <translation>O modelo tem uma pele sem matrizes de ligação: seus pontos são tomados como estão gravados, não como as articulações os colocam; onde ficarem errados, aplique o esqueleto em um programa de modelagem</translation>
    </message>
    <message>
        <source>Points joined along seams that rounding had opened: %1</source>
        <translation>Pontos unidos ao longo de costuras que o arredondamento tinha aberto: %1</translation>
    </message>
    <message>
        <source>Triangles removed that the file gives twice: %1</source>
        <translation>Triângulos removidos que o arquivo traz em dobro: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::InkLaw</name>
    <message>
        <source>A density is from %1 to %2; zero the densitometer on a place without ink, and leave that patch out</source>
        <translation>Uma densidade vai de %1 a %2; zere o densitômetro num lugar sem tinta e deixe essa amostra de fora</translation>
    </message>
    <message>
        <source>The film&apos;s area must have grown by %1 to %2 times to be a reading</source>
        <translation>Para ser uma leitura, a área do filme precisa ter crescido de %1 a %2 vezes</translation>
    </message>
    <message>
        <source>The patch of density %1 thins as no ink does; see that its densities and stretches stand in the right rows</source>
        <translation>A amostra de densidade %1 afina como nenhuma tinta; veja se as densidades e os estiramentos estão nas linhas certas</translation>
    </message>
    <message>
        <source>The tones of an ink must stand from light to dense</source>
        <translation>Os tons de uma tinta devem ir do claro ao denso</translation>
    </message>
    <message>
        <source>Of the patches of density %1 and %2 the denser one would show less where film is stretched to %3; read both again</source>
        <translation>Das amostras de densidade %1 e %2 a mais densa mostraria menos onde o filme está estirado a %3; leia as duas de novo</translation>
    </message>
    <message>
        <source>A wedge has from 1 to %1 patches that were read on stretched film</source>
        <translation>Uma cunha tem de 1 a %1 amostras lidas em filme estirado</translation>
    </message>
    <message>
        <source>The tones must stand by ink: cyan, magenta, yellow, black, white</source>
        <translation>Os tons devem estar por tinta: ciano, magenta, amarelo, preto, branco</translation>
    </message>
    <message>
        <source>“%1” is no tone of an ink, which is its name, density, exponent, bend and greatest stretch, such as cyan 0.3 0.48 0.1 2.9</source>
        <translation>“%1” não é um tom de tinta, que é nome, densidade, expoente, curvatura e maior estiramento, como cyan 0.3 0.48 0.1 2.9</translation>
    </message>
</context>
<context>
    <name>dipwright::InspectionController</name>
    <message>
        <source>The model&apos;s texture has no chess squares to look for; dip the chessboard, or measure the pairs alone</source>
        <translation>A textura do modelo não tem quadrados de xadrez a procurar; mergulhe o tabuleiro ou meça só os pares</translation>
    </message>
    <message>
        <source>Dipped Part</source>
        <translation>Peça mergulhada</translation>
    </message>
    <message>
        <source>Film on the Water</source>
        <translation>Filme na água</translation>
    </message>
    <message>
        <source>Choose What Was Dipped</source>
        <translation>Escolher o que foi mergulhado</translation>
    </message>
    <message>
        <source>Choose What Pairs Are Of</source>
        <translation>Escolher de que são os pares</translation>
    </message>
    <message>
        <source>Reading photos</source>
        <translation>Lendo fotos</translation>
    </message>
    <message>
        <source>Photos</source>
        <translation>Fotos</translation>
    </message>
    <message>
        <source>No photos yet</source>
        <translation>Ainda não há fotos</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lendo %1</translation>
    </message>
    <message>
        <source>The project names a photo outside itself:</source>
        <translation>O projeto nomeia uma foto fora dele:</translation>
    </message>
    <message>
        <source>The photo %1 is another one than its places were clicked in.</source>
        <translation>A foto %1 não é aquela em que seus pontos foram clicados.</translation>
    </message>
    <message>
        <source>Finding corners</source>
        <translation>Procurando cantos</translation>
    </message>
    <message>
        <source>Measuring pairs</source>
        <translation>Medindo pares</translation>
    </message>
    <message>
        <source>Export Residuals to a Folder</source>
        <translation>Exportar desvios para uma pasta</translation>
    </message>
    <message>
        <source>Export Residuals</source>
        <translation>Exportar desvios</translation>
    </message>
    <message>
        <source>Wrote the residuals to %1</source>
        <translation>Desvios gravados em %1</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>As Built</source>
        <translation>Como saiu</translation>
    </message>
</context>
<context>
    <name>dipwright::JigModel</name>
    <message>
        <source>Its box and that of %1 overlap; move them apart on the jig</source>
        <translation>Sua caixa e a de %1 se sobrepõem; afaste-as no suporte</translation>
    </message>
    <message>
        <source>A jig holds one part or more, with %1 materials at most</source>
        <translation>Um suporte leva uma peça ou mais, com no máximo %1 materiais</translation>
    </message>
</context>
<context>
    <name>dipwright::JobQueue</name>
    <message>
        <source>%1 % of the body painted</source>
        <translation>%1 % do corpo pintado</translation>
    </message>
    <message>
        <source>Cancelling …</source>
        <translation>Cancelando …</translation>
    </message>
    <message>
        <source>The queue has ended. Projects done: %1</source>
        <translation>A fila terminou. Projetos concluídos: %1</translation>
    </message>
    <message>
        <source>, failed: %1</source>
        <translation>, com falha: %1</translation>
    </message>
    <message>
        <source>, cancelled: %1</source>
        <translation>, cancelados: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::SeamFields</name>
    <message>
        <source>The whole face</source>
        <translation>A face inteira</translation>
    </message>
    <message>
        <source>Keeps the join away</source>
        <translation>Afasta a junção</translation>
    </message>
    <message>
        <source>Lets the join run there</source>
        <translation>Deixa a junção passar ali</translation>
    </message>
    <message>
        <source>What a click or a drag on the body in the view marks there. Give places to the other dip to move the join. With Run Live the join follows at once.</source>
        <translation>O que um clique ou um arrasto no corpo na vista marca ali. Dê lugares à outra imersão para mover a junção. Com “Executar ao vivo” a junção acompanha na hora.</translation>
    </message>
    <message>
        <source>Marks the flat face that is clicked, up to its edges.</source>
        <translation>Marca a face plana clicada, até as suas arestas.</translation>
    </message>
    <message>
        <source>Gives the place to %1</source>
        <translation>Dá o lugar a %1</translation>
    </message>
</context>
<context>
    <name>dipwright::LogPanel</name>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Nothing has happened yet.</source>
        <translation>Nada aconteceu ainda.</translation>
    </message>
    <message>
        <source>Copy Report</source>
        <translation>Copiar relatório</translation>
    </message>
    <message>
        <source>Copies the log with facts about program and machine to the clipboard.</source>
        <translation>Copia o registro com dados do programa e da máquina para a área de transferência.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Limpar</translation>
    </message>
    <message>
        <source>Empties the log.</source>
        <translation>Esvazia o registro.</translation>
    </message>
</context>
<context>
    <name>dipwright::LookInsideBar</name>
    <message>
        <source>Where body and film are cut open; the frame in the view can be dragged, too</source>
        <translation>Onde corpo e filme são abertos; a moldura na vista também pode ser arrastada</translation>
    </message>
    <message>
        <source>How much the film covers of what lies behind it</source>
        <translation>Quanto o filme cobre do que está atrás dele</translation>
    </message>
    <message>
        <source>Direction of the section</source>
        <translation>Direção do corte</translation>
    </message>
    <message>
        <source>Show the other side</source>
        <translation>Mostrar o outro lado</translation>
    </message>
    <message>
        <source>Film covers</source>
        <translation>Filme cobre</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Across X</source>
        <translation>Transversal a X</translation>
    </message>
    <message>
        <source>Level, across Y</source>
        <translation>Nivelado, transversal a Y</translation>
    </message>
    <message>
        <source>Across Z</source>
        <translation>Transversal a Z</translation>
    </message>
</context>
<context>
    <name>dipwright::MainWindow</name>
    <message>
        <source>Cancelling …</source>
        <translation>Cancelando…</translation>
    </message>
    <message>
        <source>Layout “%1”</source>
        <translation>Disposição “%1”</translation>
    </message>
    <message>
        <source>The body is %1 long. If its file is in another unit, change its size under Model.</source>
        <translation>O corpo tem %1 de comprimento. Se o arquivo está em outra unidade, mude o tamanho em “Modelo”.</translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation>Inspeção</translation>
    </message>
</context>
<context>
    <name>dipwright::MarkFields</name>
    <message>
        <source>Remove Last</source>
        <translation>Remover a última</translation>
    </message>
    <message>
        <source>Remove All</source>
        <translation>Remover todas</translation>
    </message>
    <message>
        <source>A click on the body</source>
        <translation>Um clique no corpo</translation>
    </message>
    <message>
        <source>Marks nothing</source>
        <translation>Não marca nada</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Raio</translation>
    </message>
    <message>
        <source>How far round the click the mark reaches, along the surface.</source>
        <translation>Até onde a marca chega em volta do clique, ao longo da superfície.</translation>
    </message>
    <message>
        <source>A click</source>
        <translation>Um clique</translation>
    </message>
    <message>
        <source>Marks on the body: %1</source>
        <translation>Marcas no corpo: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::MeasurePlot</name>
    <message>
        <source>Measure to the right</source>
        <translation>Medida para a direita</translation>
    </message>
    <message>
        <source>Measure upwards</source>
        <translation>Medida para cima</translation>
    </message>
    <message>
        <source>Better is to the right and up. The line joins the poses that no other beats in both measures.</source>
        <translation>Melhor é à direita e acima. A linha liga as poses que nenhuma outra supera em ambas as medidas.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Rank %1</source>
        <translation>Posição %1</translation>
    </message>
</context>
<context>
    <name>dipwright::MeasureTool</name>
    <message>
        <source>Click the second place on the body</source>
        <translation>Clique no segundo lugar do corpo</translation>
    </message>
    <message>
        <source>Distance %1</source>
        <translation>Distância %1</translation>
    </message>
</context>
<context>
    <name>dipwright::ModelFile</name>
    <message>
        <source>a texture of the model</source>
        <translation>uma textura do modelo</translation>
    </message>
    <message>
        <source>The stored model is damaged; import the model again</source>
        <translation>O modelo guardado está danificado; importe o modelo de novo</translation>
    </message>
    <message>
        <source>The stored model has format version %1 and this program reads version %2; use a newer program</source>
        <translation>O modelo guardado tem a versão de formato %1 e este programa lê a versão %2; use um programa mais novo</translation>
    </message>
</context>
<context>
    <name>dipwright::ModelFormats</name>
    <message>
        <source>%1 or %2</source>
        <extracomment>Names of file formats: &quot;OBJ, PLY, STL, glTF&quot; or &quot;3MF&quot;</extracomment>
        <translation>%1 ou %2</translation>
    </message>
</context>
<context>
    <name>dipwright::NewProjectDialog</name>
    <message>
        <source>Models (%1)</source>
        <translation>Modelos (%1)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Imagens (%1)</translation>
    </message>
    <message>
        <source>Dipwright projects (%1)</source>
        <translation>Projetos do Dipwright (%1)</translation>
    </message>
    <message>
        <source>One unit of the file is</source>
        <translation>Uma unidade do arquivo é</translation>
    </message>
    <message>
        <source>The longest edge is</source>
        <translation>A aresta mais longa tem</translation>
    </message>
    <message>
        <source>New Project</source>
        <translation>Novo projeto</translation>
    </message>
    <message>
        <source>The model&apos;s own</source>
        <translation>A do próprio modelo</translation>
    </message>
    <message>
        <source>The size in which the film comes and is printed.</source>
        <translation>O tamanho em que o filme vem e é impresso.</translation>
    </message>
    <message>
        <source>One dip</source>
        <translation>Uma imersão</translation>
    </message>
    <message>
        <source>Two dips: bottom and top</source>
        <translation>Duas imersões: embaixo e em cima</translation>
    </message>
    <message>
        <source>Two dips: left and right</source>
        <translation>Duas imersões: esquerda e direita</translation>
    </message>
    <message>
        <source>One dip with the film model of 2020, to compare</source>
        <translation>Uma imersão com o modelo de filme de 2020, para comparar</translation>
    </message>
    <message>
        <source>How often and from where the body is dipped. All of it can be changed later.</source>
        <translation>Quantas vezes e de onde o corpo é mergulhado. Tudo pode ser mudado depois.</translation>
    </message>
    <message>
        <source>&amp;Model</source>
        <translation>&amp;Modelo</translation>
    </message>
    <message>
        <source>Choose a Model</source>
        <translation>Escolher um modelo</translation>
    </message>
    <message>
        <source>Te&amp;xture</source>
        <translation>Te&amp;xtura</translation>
    </message>
    <message>
        <source>Choose a Texture</source>
        <translation>Escolher uma textura</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>&amp;Film</source>
        <translation>&amp;Filme</translation>
    </message>
    <message>
        <source>&amp;Begin with</source>
        <translation>&amp;Começar com</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Criar</translation>
    </message>
    <message>
        <source>a millimetre</source>
        <translation>um milímetro</translation>
    </message>
    <message>
        <source>a centimetre</source>
        <translation>um centímetro</translation>
    </message>
    <message>
        <source>a metre</source>
        <translation>um metro</translation>
    </message>
    <message>
        <source>an inch</source>
        <translation>uma polegada</translation>
    </message>
    <message>
        <source>Longest edge</source>
        <translation>Aresta mais longa</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Unidade do arquivo</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Embaixo</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Em cima</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Direita</translation>
    </message>
    <message>
        <source>The file of the body that is to be dipped.</source>
        <translation>O arquivo do corpo a ser mergulhado.</translation>
    </message>
    <message>
        <source>A picture to wear in place of the model&apos;s own texture, or nothing.</source>
        <translation>Uma imagem no lugar da textura do próprio modelo, ou nada.</translation>
    </message>
    <message>
        <source>The model is made larger or smaller until its longest edge measures this.</source>
        <translation>O modelo é ampliado ou reduzido até que sua aresta mais longa tenha esta medida.</translation>
    </message>
    <message>
        <source>In which unit the model&apos;s file gives its coordinates. The file does not say.</source>
        <translation>Em que unidade o arquivo do modelo dá suas coordenadas. O arquivo não o diz.</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textura</translation>
    </message>
    <message>
        <source>Choose a file: %1</source>
        <translation>Escolha um arquivo: %1</translation>
    </message>
    <message>
        <source>Reading the model …</source>
        <translation>Lendo o modelo …</translation>
    </message>
    <message>
        <source>Reading the model</source>
        <translation>Lendo o modelo</translation>
    </message>
    <message>
        <source>The body is %1 × %2 × %3</source>
        <translation>O corpo mede %1 × %2 × %3</translation>
    </message>
    <message>
        <source>the unit is a guess by its size.</source>
        <translation>a unidade é suposta pelo tamanho.</translation>
    </message>
    <message>
        <source>What is known of the film: how it swells, grows and tears.</source>
        <translation>O que se sabe do filme: como incha, cresce e rasga.</translation>
    </message>
    <message>
        <source>Film &amp;profile</source>
        <translation>&amp;Perfil do filme</translation>
    </message>
</context>
<context>
    <name>dipwright::NoticeBar</name>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>Close this notice</source>
        <translation>Fechar este aviso</translation>
    </message>
</context>
<context>
    <name>dipwright::NumberBox</name>
    <message>
        <source>“%1” has a unit, and this field has none; type the number alone</source>
        <translation>“%1” tem uma unidade e este campo não tem nenhuma; digite só o número</translation>
    </message>
    <message>
        <source>“%1” is in no unit of this field; type a number in %2</source>
        <translation>“%1” não está em nenhuma unidade deste campo; digite um número em %2</translation>
    </message>
    <message>
        <source>There is no number</source>
        <translation>Não há número</translation>
    </message>
    <message>
        <source>“%1” is no number</source>
        <translation>“%1” não é um número</translation>
    </message>
    <message>
        <source>“%1” is not within %2 to %3%4</source>
        <translation>“%1” não está entre %2 e %3%4</translation>
    </message>
    <message>
        <source>“%1” can be %2 or %3; type one of them</source>
        <translation>“%1” pode ser %2 ou %3; digite um deles</translation>
    </message>
    <message>
        <source>“%1” is no whole number</source>
        <translation>“%1” não é um número inteiro</translation>
    </message>
</context>
<context>
    <name>dipwright::OrientationMap</name>
    <message>
        <source>How good each side is to go down first</source>
        <translation>Quão bom é cada lado para descer primeiro</translation>
    </message>
    <message>
        <source>Which side
goes down first</source>
        <translation>Que lado
desce primeiro</translation>
    </message>
    <message>
        <source>Objective %1, click to try this side</source>
        <translation>Objetivo %1, clique para experimentar este lado</translation>
    </message>
</context>
<context>
    <name>dipwright::PackDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Turn pieces where that saves film</source>
        <translation>&amp;Girar peças onde isso poupa filme</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Filme</translation>
    </message>
    <message>
        <source>Add projects and lay them out.</source>
        <translation>Adicione projetos e disponha-os.</translation>
    </message>
    <message>
        <source>Several Jobs on One Film</source>
        <translation>Vários trabalhos em um filme</translation>
    </message>
    <message>
        <source>Projects on the film</source>
        <translation>Projetos no filme</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projeto</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Cópias</translation>
    </message>
    <message>
        <source>Project files may be dropped here. They are taken as they are saved.</source>
        <translation>Arquivos de projeto podem ser soltos aqui. São tomados como estão salvos.</translation>
    </message>
    <message>
        <source>&amp;Add Projects…</source>
        <translation>&amp;Adicionar projetos…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Remover</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rolo</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizado</translation>
    </message>
    <message>
        <source>Short edge first</source>
        <translation>Borda curta primeiro</translation>
    </message>
    <message>
        <source>Long edge first</source>
        <translation>Borda longa primeiro</translation>
    </message>
    <message>
        <source>Film swells more along its web. Pieces of films that swell differently both ways lie along it as they were computed.</source>
        <translation>O filme incha mais ao longo de sua banda. Peças de filmes que incham de modo diferente nos dois sentidos ficam em relação a ela como foram calculadas.</translation>
    </message>
    <message>
        <source>Bare film round what is inked. A job is computed for its whole film: cut out near its ink it behaves otherwise towards the edge.</source>
        <translation>Filme livre em volta da tinta. Um trabalho é calculado para o filme inteiro: cortado perto da tinta, ele se comporta de outro modo perto da borda.</translation>
    </message>
    <message>
        <source>By a quarter, and only pieces of films that swell alike both ways.</source>
        <translation>Em um quarto de volta, e só peças de filmes que incham igualmente nos dois sentidos.</translation>
    </message>
    <message>
        <source>&amp;Film</source>
        <translation>&amp;Filme</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Largura</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Comprimento</translation>
    </message>
    <message>
        <source>Fe&amp;ed</source>
        <translation>Alime&amp;ntação</translation>
    </message>
    <message>
        <source>&amp;Spacing</source>
        <translation>&amp;Espaçamento</translation>
    </message>
    <message>
        <source>&amp;Bare film</source>
        <translation>Filme l&amp;ivre</translation>
    </message>
    <message>
        <source>Film that is shown</source>
        <translation>Filme mostrado</translation>
    </message>
    <message>
        <source>La&amp;y Out</source>
        <translation>Di&amp;spor</translation>
    </message>
    <message>
        <source>Dips what has not been dipped yet, and lays it out.</source>
        <translation>Mergulha o que ainda não foi mergulhado e o dispõe.</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xportar…</translation>
    </message>
    <message>
        <source>Each film as PDF, PNG and TIFF at true size, and what lies where.</source>
        <translation>Cada filme em PDF, PNG e TIFF em tamanho real, e o que está onde.</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>Im&amp;primir…</translation>
    </message>
    <message>
        <source>Copies of %1</source>
        <translation>Cópias de %1</translation>
    </message>
    <message>
        <source>Add Projects</source>
        <translation>Adicionar projetos</translation>
    </message>
    <message>
        <source>At most; it is cut off behind the last piece.</source>
        <translation>No máximo; é cortado depois da última peça.</translation>
    </message>
    <message>
        <source>Laying out</source>
        <translation>Dispondo</translation>
    </message>
    <message>
        <source>Films: %1. They are printed at true size.</source>
        <translation>Filmes: %1. São impressos em tamanho real.</translation>
    </message>
    <message>
        <source>Export Films to a Folder</source>
        <translation>Exportar filmes para uma pasta</translation>
    </message>
    <message>
        <source>Writing the films</source>
        <translation>Gravando os filmes</translation>
    </message>
    <message>
        <source>Wrote the films to %1</source>
        <translation>Filmes gravados em %1</translation>
    </message>
    <message>
        <source>Several jobs</source>
        <translation>Vários trabalhos</translation>
    </message>
    <message>
        <source>Film %1</source>
        <translation>Filme %1</translation>
    </message>
    <message>
        <source>Press Lay Out: projects that have not been dipped here are dipped first.</source>
        <translation>Pressione Dispor: projetos que ainda não foram mergulhados aqui são mergulhados antes.</translation>
    </message>
    <message>
        <source>Add projects, or drop their files here.</source>
        <translation>Adicione projetos ou solte seus arquivos aqui.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Cancelado.</translation>
    </message>
</context>
<context>
    <name>dipwright::PaintArtwork</name>
    <message>
        <source>The artwork does not fit into this computer&apos;s memory; choose a lower resolution of the sheet</source>
        <translation>A arte não cabe na memória deste computador; escolha uma resolução menor da folha</translation>
    </message>
    <message>
        <source>Painting the artwork</source>
        <translation>Pintando a arte</translation>
    </message>
</context>
<context>
    <name>dipwright::PartCamera</name>
    <message>
        <source>Photo %1 has %2 pairs of places and takes %3 to tell its camera; give more</source>
        <translation>A foto %1 tem %2 pares de lugares e precisa de %3 para dizer a câmera; dê mais</translation>
    </message>
    <message>
        <source>All places of photo %1 lie in one plane, which does not tell how far the camera was; give some on other faces</source>
        <translation>Todos os lugares da foto %1 ficam num plano, o que não diz a que distância estava a câmera; dê alguns em outras faces</translation>
    </message>
    <message>
        <source>The pairs do not tell the camera; give more, farther apart</source>
        <translation>Os pares não determinam a câmera; dê mais, mais afastados</translation>
    </message>
    <message>
        <source>The pairs do not tell how far the camera was; give places that lie nearer and farther, and photograph from less far away</source>
        <translation>Os pares não dizem a que distância estava a câmera; dê lugares mais próximos e mais distantes, e fotografe de mais perto</translation>
    </message>
    <message>
        <source>The first line of the pairs is not %1</source>
        <translation>A primeira linha dos pares não é %1</translation>
    </message>
    <message>
        <source>There are more than %1 pairs</source>
        <translation>Há mais de %1 pares</translation>
    </message>
    <message>
        <source>Rings: expected · lines: to where it is seen, %1 times as long</source>
        <translation>Anéis: esperado · linhas: até onde se vê, %1 vezes mais longas</translation>
    </message>
    <message>
        <source>Photo %1 shows its places as in a mirror; give the photo as the camera made it, and the places with the model&apos;s own signs</source>
        <translation>A foto %1 mostra seus lugares como num espelho; forneça a foto como a câmera a fez, e os lugares com os sinais do próprio modelo</translation>
    </message>
    <message>
        <source>By its places, photo %1 shows none of the print; give them again, or photograph the side that was dipped</source>
        <translation>Pelos seus pontos, a foto %1 não mostra nada da impressão; indique-os de novo ou fotografe o lado que foi mergulhado</translation>
    </message>
    <message>
        <source>In photo %1 black and white are swapped: the film was laid with its ink down, or turned by a square</source>
        <translation>Na foto %1 o preto e o branco estão trocados: o filme foi posto com a tinta para baixo ou deslocado de um quadrado</translation>
    </message>
    <message>
        <source>Of %1 corners that photo %2 should show, %3 were found: is this the job&apos;s part and print, sharp and whole, and were its places given rightly?</source>
        <translation>Dos %1 cantos que a foto %2 deveria mostrar, foram encontrados %3: é a peça e a impressão deste trabalho, nítida e inteira, e os pontos indicados estão certos?</translation>
    </message>
    <message>
        <source>Finding corners in photo %1</source>
        <translation>Procurando cantos na foto %1</translation>
    </message>
    <message>
        <source>Line %1 of the pairs is not %2</source>
        <translation>A linha %1 dos pares não é %2</translation>
    </message>
    <message>
        <source>the number of a photo, two numbers of pixels and three of millimetres, joined by commas</source>
        <translation>o número de uma foto, dois números em pixels e três em milímetros, separados por vírgulas</translation>
    </message>
    <message>
        <source>the number of a photo, two numbers of pixels, the number of a dip, and two and three of millimetres, joined by commas</source>
        <translation>o número de uma foto, dois números em pixels, o número de uma imersão, e dois e três em milímetros, separados por vírgulas</translation>
    </message>
    <message>
        <source>The photos are of different sizes; take those of one camera, held the same way</source>
        <translation>As fotos têm tamanhos diferentes; use as de uma só câmera, segurada do mesmo modo</translation>
    </message>
    <message>
        <source>With this photo those of the part have %1 million pixels together, and %2 may be held at once; give fewer, or smaller ones</source>
        <translation>Com esta foto, as da peça têm juntas %1 milhões de pixels, e %2 podem ser mantidos ao mesmo tempo; use menos, ou menores</translation>
    </message>
</context>
<context>
    <name>dipwright::PartPage</name>
    <message>
        <source>Photo of the dipped part</source>
        <translation>Foto da peça mergulhada</translation>
    </message>
    <message>
        <source>How far the print lies off</source>
        <translation>Quanto a impressão se desvia</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Pontos</translation>
    </message>
    <message>
        <source>Mean distance in the photo and its deviation</source>
        <translation>Distância média na foto e seu desvio</translation>
    </message>
    <message>
        <source>The mean over the photo&apos;s diagonal, as in the paper&apos;s Table II</source>
        <translation>A média dividida pela diagonal da foto, como na Tabela II do artigo</translation>
    </message>
    <message>
        <source>On the body, across the line of sight: 95 % are nearer</source>
        <translation>No corpo, transversal à linha de visão: 95 % estão mais perto</translation>
    </message>
    <message>
        <source>On the body, the farthest</source>
        <translation>No corpo, a mais distante</translation>
    </message>
    <message>
        <source>Add &amp;Photos…</source>
        <translation>Adicionar &amp;fotos…</translation>
    </message>
    <message>
        <source>Photo</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Remove this photo and its pairs</source>
        <translation>Remover esta foto e seus pares</translation>
    </message>
    <message>
        <source>Remove Photo</source>
        <translation>Remover foto</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>Imagem inteira</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Ampliar</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Reduzir</translation>
    </message>
    <message>
        <source>Photos of the Dipped Part</source>
        <translation>Fotos da peça mergulhada</translation>
    </message>
    <message>
        <source>Photos (%1)</source>
        <translation>Fotos (%1)</translation>
    </message>
    <message>
        <source>Dipped into the c&amp;hessboard of 17 mm</source>
        <translation>Mergulhada no &amp;tabuleiro de 17 mm</translation>
    </message>
    <message>
        <source>Look for the corners of the built-in chessboard; else for those of chess squares in the model&apos;s texture</source>
        <translation>Procura os cantos do tabuleiro embutido; senão, os de quadrados de xadrez na textura do modelo</translation>
    </message>
    <message>
        <source>The pairs are places of the body &amp;itself</source>
        <translation>Os pares são pontos do próprio &amp;corpo</translation>
    </message>
    <message>
        <source>Tips and edges, not places of the print: the camera stays as these pairs have it, so that a print that is shifted as a whole shows</source>
        <translation>Pontas e arestas, não pontos da impressão: a câmera fica como estes pares a dão, de modo que uma impressão toda deslocada aparece</translation>
    </message>
    <message>
        <source>Measure &amp;Pairs</source>
        <translation>Medir &amp;pares</translation>
    </message>
    <message>
        <source>Fit the camera to the pairs and say how far they are off</source>
        <translation>Ajustar a câmera aos pares e dizer quanto se desviam</translation>
    </message>
    <message>
        <source>&amp;Find Corners</source>
        <translation>Pro&amp;curar cantos</translation>
    </message>
    <message>
        <source>Find the corners of the print in all photos and hold them against the simulated film</source>
        <translation>Procurar os cantos da impressão em todas as fotos e compará-los com o filme simulado</translation>
    </message>
    <message>
        <source>&amp;Remove Pair</source>
        <translation>&amp;Remover par</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>Write table, places and photos with residuals to a folder</source>
        <translation>Gravar tabela, pontos e fotos com desvios numa pasta</translation>
    </message>
    <message>
        <source>Photo %1</source>
        <translation>Foto %1</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>Add photos of the dipped part, or drop them here: sharp, whole, of one camera, from near enough that the part fills the picture.</source>
        <translation>Adicione fotos da peça mergulhada ou solte-as aqui: nítidas, inteiras, de uma só câmera, de perto o bastante para a peça encher a imagem.</translation>
    </message>
    <message>
        <source>Now click the same place on the body in the 3D view.</source>
        <translation>Agora clique o mesmo ponto no corpo, na vista 3D.</translation>
    </message>
    <message>
        <source>%1 of %2 corners found.</source>
        <translation>%1 de %2 cantos encontrados.</translation>
    </message>
    <message>
        <source>The camera follows the print: a shift or turn of all of it does not show.</source>
        <translation>A câmera segue a impressão: um deslocamento ou giro do todo não aparece.</translation>
    </message>
    <message>
        <source>The camera is that of the pairs.</source>
        <translation>A câmera é a dos pares.</translation>
    </message>
    <message>
        <source>Click a place in the photo, then the same place on the body: %1 of %2 pairs, spread over several faces.</source>
        <translation>Clique um ponto na foto e depois o mesmo no corpo: %1 de %2 pares, espalhados por várias faces.</translation>
    </message>
    <message>
        <source>%1 pairs. Drag a place to correct it; Delete removes it. Then find the corners, or measure the pairs alone.</source>
        <translation>%1 pares. Arraste um ponto para corrigi-lo; Delete o remove. Depois procure os cantos ou meça só os pares.</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>R ± σ, px</source>
        <translation>R ± σ, px</translation>
    </message>
    <message>
        <source>R, %</source>
        <translation>R, %</translation>
    </message>
    <message>
        <source>95 %, mm</source>
        <translation>95 %, mm</translation>
    </message>
    <message>
        <source>Worst, mm</source>
        <translation>Pior, mm</translation>
    </message>
</context>
<context>
    <name>dipwright::PhotoView</name>
    <message>
        <source>Lines: residuals, %1 times as long</source>
        <translation>Linhas: desvios, %1 vezes</translation>
    </message>
</context>
<context>
    <name>dipwright::PicturePanel</name>
    <message>
        <source>Whole picture</source>
        <translation>Imagem inteira</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Ampliar</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Reduzir</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>True size</source>
        <translation>Tamanho real</translation>
    </message>
</context>
<context>
    <name>dipwright::PoseTable</name>
    <message>
        <source>%1: turned by %2° about X, Y, Z</source>
        <translation>%1: girado %2° em torno de X, Y, Z</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Poses found, the best first</source>
        <translation>Poses encontradas, a melhor primeiro</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Pose</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Painted,
stretch</source>
        <translation>Pintado,
estiramento</translation>
    </message>
    <message>
        <source>Against the best</source>
        <translation>Contra a melhor</translation>
    </message>
    <message>
        <source>≈ %1</source>
        <comment>about</comment>
        <translation>≈ %1</translation>
    </message>
    <message>
        <source>Misses a limit. %1</source>
        <translation>Não cumpre um limite. %1</translation>
    </message>
    <message>
        <source>Compared with your pose: %1</source>
        <translation>Comparado com a sua pose: %1</translation>
    </message>
</context>
<context>
    <name>dipwright::PreferencesDialog</name>
    <message>
        <source>Run again after each change</source>
        <translation>Executar de novo após cada mudança</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Preferências</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Geral</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Atalhos</translation>
    </message>
    <message>
        <source>Solvers</source>
        <translation>Solucionadores</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Como o sistema</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Milímetros</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Polegadas</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Escuro</translation>
    </message>
    <message>
        <source>Turntable: up stays up</source>
        <translation>Mesa giratória: o alto fica no alto</translation>
    </message>
    <message>
        <source>Trackball: turns freely</source>
        <translation>Trackball: gira livremente</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>How long after a change, at most, a copy is kept from which work is restored after a crash.</source>
        <translation>Quanto tempo, no máximo, após uma mudança é guardada uma cópia da qual o trabalho é restaurado após uma queda.</translation>
    </message>
    <message>
        <source>Once there is a result, a change starts a new run of what depends on it.</source>
        <translation>Havendo um resultado, uma mudança recalcula o que depende dela.</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>A new language shows when the program is started again.</source>
        <translation>Um novo idioma aparece ao reiniciar o programa.</translation>
    </message>
    <message>
        <source>L&amp;engths in</source>
        <translation>&amp;Comprimentos em</translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>&amp;Navegação</translation>
    </message>
    <message>
        <source>&amp;Film of new projects</source>
        <translation>&amp;Filme de projetos novos</translation>
    </message>
    <message>
        <source>&amp;Recovery copy after</source>
        <translation>Cópia de &amp;recuperação após</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Comando</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>All Back to Standard</source>
        <translation>Restaurar todos</translation>
    </message>
    <message>
        <source>The film that is proposed when a project is made.</source>
        <translation>O filme proposto quando um projeto é criado.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nenhuma</translation>
    </message>
    <message>
        <source>The printer profile that new projects begin with. It can be changed under Sheet.</source>
        <translation>O perfil de impressora com que novos projetos começam. Pode ser mudado em Folha.</translation>
    </message>
    <message>
        <source>The language of menus, panels and messages.</source>
        <translation>O idioma de menus, painéis e mensagens.</translation>
    </message>
    <message>
        <source>The unit in which lengths and speeds are shown and typed.</source>
        <translation>A unidade em que comprimentos e velocidades são mostrados e digitados.</translation>
    </message>
    <message>
        <source>Light or dark colours.</source>
        <translation>Cores claras ou escuras.</translation>
    </message>
    <message>
        <source>How dragging in the view turns it.</source>
        <translation>Como arrastar na vista a gira.</translation>
    </message>
    <message>
        <source>&amp;Printer of new projects</source>
        <translation>&amp;Impressora de novos projetos</translation>
    </message>
    <message>
        <source>%1 stands for both “%2” and “%3”. Change one of them.</source>
        <translation>%1 vale para “%2” e para “%3”. Mude um deles.</translation>
    </message>
    <message>
        <source>The film profile that is proposed when a project is made.</source>
        <translation>O perfil de filme proposto quando um projeto é criado.</translation>
    </message>
    <message>
        <source>Film p&amp;rofile of new projects</source>
        <translation>Pe&amp;rfil de filme de novos projetos</translation>
    </message>
    <message>
        <source>Keep results beside the project</source>
        <translation>Guardar resultados ao lado do projeto</translation>
    </message>
    <message>
        <source>The dips of a saved project are kept in a file NAME.dips beside it, up to 64 MB, and its results are there when it is opened again.</source>
        <translation>As imersões de um projeto salvo são guardadas num arquivo NOME.dips ao lado dele, até 64 MB, e seus resultados estão lá quando ele é aberto de novo.</translation>
    </message>
</context>
<context>
    <name>dipwright::PrintDialog</name>
    <message>
        <source>Print Sheets</source>
        <translation>Imprimir folhas</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Imprimir</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Impressora</translation>
    </message>
    <message>
        <source>&amp;Printer</source>
        <translation>&amp;Impressora</translation>
    </message>
    <message>
        <source>None: true size and sRGB (choose one under Sheet)</source>
        <translation>Nenhum: tamanho real e sRGB (escolha um em Folha)</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Perfil</translation>
    </message>
    <message>
        <source>&amp;Copies</source>
        <translation>&amp;Cópias</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>Folhas</translation>
    </message>
    <message>
        <source>Looking for printers …</source>
        <translation>Procurando impressoras…</translation>
    </message>
    <message>
        <source>Looking for printers</source>
        <translation>Procurando impressoras</translation>
    </message>
    <message>
        <source>No printer is set up on this machine. Save the sheet as PDF and print it elsewhere, at 100 %.</source>
        <translation>Não há impressora configurada nesta máquina. Salve a folha em PDF e imprima em outro lugar, a 100 %.</translation>
    </message>
    <message>
        <source>Choose at least one sheet.</source>
        <translation>Escolha ao menos uma folha.</translation>
    </message>
    <message>
        <source>Asking the printer …</source>
        <translation>Consultando a impressora…</translation>
    </message>
    <message>
        <source>Asking the printer</source>
        <translation>Consultando a impressora</translation>
    </message>
    <message>
        <source>Printing …</source>
        <translation>Imprimindo…</translation>
    </message>
    <message>
        <source>Printing</source>
        <translation>Imprimindo</translation>
    </message>
    <message>
        <source>Printed on %1</source>
        <translation>Impresso em %1</translation>
    </message>
    <message>
        <source>Handed to the queue of %1</source>
        <translation>Entregue à fila de %1</translation>
    </message>
    <message>
        <source>Whether this immersion&apos;s sheet is printed.</source>
        <translation>Se a folha desta imersão é impressa.</translation>
    </message>
    <message>
        <source>The printers that are set up on this machine.</source>
        <translation>As impressoras instaladas nesta máquina.</translation>
    </message>
    <message>
        <source>How often each sheet is printed.</source>
        <translation>Quantas vezes cada folha é impressa.</translation>
    </message>
    <message>
        <source>Without this tick such a print is refused, with the reason.</source>
        <translation>Sem esta marca, uma impressão assim é recusada, com o motivo.</translation>
    </message>
    <message>
        <source>Save as File…</source>
        <translation>Salvar como arquivo…</translation>
    </message>
    <message>
        <source>The sheet shown, as PDF or TIFF in the printer&apos;s scale and colours.</source>
        <translation>A folha mostrada, como PDF ou TIFF na escala e nas cores da impressora.</translation>
    </message>
    <message>
        <source>Cancelled. What the printer has already begun may still come out.</source>
        <translation>Cancelado. O que a impressora já começou ainda pode sair.</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Filme</translation>
    </message>
    <message>
        <source>The film itself</source>
        <translation>O próprio filme</translation>
    </message>
    <message>
        <source>Custom, as set under Sheet</source>
        <translation>Personalizado, como definido em Folha</translation>
    </message>
    <message>
        <source>Portrait</source>
        <translation>Retrato</translation>
    </message>
    <message>
        <source>Landscape</source>
        <translation>Paisagem</translation>
    </message>
    <message>
        <source>P&amp;aper</source>
        <translation>P&amp;apel</translation>
    </message>
    <message>
        <source>&amp;Orientation</source>
        <translation>&amp;Orientação</translation>
    </message>
    <message>
        <source>As designed</source>
        <translation>Como projetado</translation>
    </message>
    <message>
        <source>As printed (soft proof)</source>
        <translation>Como impresso (prova virtual)</translation>
    </message>
    <message>
        <source>As printed, colours out of reach in magenta</source>
        <translation>Como impresso, cores fora de alcance em magenta</translation>
    </message>
    <message>
        <source>How the page is shown here. What is printed stays the same.</source>
        <translation>Como a página é mostrada aqui. O que se imprime não muda.</translation>
    </message>
    <message>
        <source>A soft proof needs a printer profile with an ICC profile.</source>
        <translation>A prova virtual precisa de um perfil de impressora com perfil ICC.</translation>
    </message>
    <message>
        <source>Colours of the page</source>
        <translation>Cores da página</translation>
    </message>
    <message>
        <source>Proofing the colours</source>
        <translation>Verificando as cores</translation>
    </message>
    <message>
        <source>%1 % of the paint is out of the printer&apos;s reach.</source>
        <translation>%1 % da pintura está fora do alcance da impressora.</translation>
    </message>
    <message>
        <source>Save Sheet</source>
        <translation>Salvar folha</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 gravado</translation>
    </message>
    <message>
        <source>Ready to print at true size. Pages: %1.</source>
        <translation>Pronto para imprimir em tamanho real. Páginas: %1.</translation>
    </message>
    <message>
        <source>The paper that the sheet is printed on.</source>
        <translation>O papel em que a folha é impressa.</translation>
    </message>
    <message>
        <source>None is set up</source>
        <translation>Nenhuma configurada</translation>
    </message>
    <message>
        <source>Tile the sheet if the paper is too small</source>
        <translation>Dividir a folha em partes se o papel for pequeno demais</translation>
    </message>
    <message>
        <source>Print in grey on a monochrome printer</source>
        <translation>Imprimir em cinza numa impressora monocromática</translation>
    </message>
    <message>
        <source>Clip what lies outside the printable area</source>
        <translation>Cortar o que fica fora da área imprimível</translation>
    </message>
    <message>
        <source>The printer does not report this paper as loaded</source>
        <translation>A impressora não informa este papel como carregado</translation>
    </message>
    <message>
        <source>Print anyway</source>
        <translation>Imprimir assim mesmo</translation>
    </message>
</context>
<context>
    <name>dipwright::PrintFields</name>
    <message>
        <source>Shown</source>
        <translation>Mostrado</translation>
    </message>
    <message>
        <source>Shift X</source>
        <translation>Desvio X</translation>
    </message>
    <message>
        <source>How far the second film lies off along X.</source>
        <translation>Quanto o segundo filme desvia ao longo de X.</translation>
    </message>
    <message>
        <source>Shift Z</source>
        <translation>Desvio Z</translation>
    </message>
    <message>
        <source>How far it lies off along Z.</source>
        <translation>Quanto ele desvia ao longo de Z.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>How far it is turned, from X to Z.</source>
        <translation>Quanto ele está girado, de X para Z.</translation>
    </message>
    <message>
        <source>Swell</source>
        <translation>Inchamento</translation>
    </message>
    <message>
        <source>How much more it has grown than the sheet reckons with.</source>
        <translation>Quanto ele cresceu além do que a folha supõe.</translation>
    </message>
    <message>
        <source>In its Place</source>
        <translation>No seu lugar</translation>
    </message>
    <message>
        <source>The second film where it belongs.</source>
        <translation>O segundo filme onde deve ficar.</translation>
    </message>
    <message>
        <source>After %1 and %2</source>
        <translation>Depois de %1 e %2</translation>
    </message>
    <message>
        <source>After %1</source>
        <translation>Depois de %1</translation>
    </message>
    <message>
        <source>Deeper</source>
        <translation>Mais fundo</translation>
    </message>
    <message>
        <source>How much deeper the body is dipped, less deep if negative: what stays over the water gets no ink. A body that is dipped whole cannot go deeper.</source>
        <translation>Quanto mais fundo o corpo é mergulhado, menos fundo se negativo: o que fica acima da água não recebe tinta. Um corpo mergulhado por inteiro não pode ir mais fundo.</translation>
    </message>
</context>
<context>
    <name>dipwright::PrintHistoryDialog</name>
    <message>
        <source>Project file: %1</source>
        <translation>Arquivo do projeto: %1</translation>
    </message>
    <message>
        <source>Written to: %1</source>
        <translation>Gravado em: %1</translation>
    </message>
    <message>
        <source>Film: %1</source>
        <translation>Filme: %1</translation>
    </message>
    <message>
        <source>Printer&apos;s profile: %1</source>
        <translation>Perfil da impressora: %1</translation>
    </message>
    <message>
        <source>Paper, in the printer&apos;s words: %1</source>
        <translation>Papel, nas palavras da impressora: %1</translation>
    </message>
    <message>
        <source>The project had not been saved when it was printed.</source>
        <translation>O projeto ainda não tinha sido salvo quando foi impresso.</translation>
    </message>
    <message>
        <source>The project&apos;s file is not there any more.</source>
        <translation>O arquivo do projeto não está mais lá.</translation>
    </message>
    <message>
        <source>Print History</source>
        <translation>Histórico de impressão</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Job number on the sheet, project, printer …</source>
        <translation>Número do trabalho na folha, projeto, impressora …</translation>
    </message>
    <message>
        <source>What was printed, the newest first</source>
        <translation>O que foi impresso, o mais recente primeiro</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Quando</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Trabalho</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projeto</translation>
    </message>
    <message>
        <source>Printer or file</source>
        <translation>Impressora ou arquivo</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Cópias</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>&amp;Open Project</source>
        <translation>&amp;Abrir projeto</translation>
    </message>
    <message>
        <source>Reading the print history</source>
        <translation>Lendo o histórico de impressão</translation>
    </message>
    <message>
        <source>Reading the print history …</source>
        <translation>Lendo o histórico de impressão…</translation>
    </message>
    <message>
        <source>Nothing has been printed yet.</source>
        <translation>Nada foi impresso ainda.</translation>
    </message>
    <message>
        <source>Nothing that was printed holds these words.</source>
        <translation>Nada do que foi impresso contém estas palavras.</translation>
    </message>
    <message>
        <source>Immersion</source>
        <translation>Imersão</translation>
    </message>
    <message>
        <source>Shows the prints that hold all words typed here, or parts of words</source>
        <translation>Mostra as impressões que contêm todas as palavras digitadas aqui, ou partes delas</translation>
    </message>
</context>
<context>
    <name>dipwright::PrinterColour</name>
    <message>
        <source>The ICC profile cannot be used for printing, choose the printer&apos;s output profile</source>
        <translation>O perfil ICC não serve para imprimir; escolha o perfil de saída da impressora</translation>
    </message>
    <message>
        <source>This is not an ICC profile, or it is damaged</source>
        <translation>Isto não é um perfil ICC, ou está danificado</translation>
    </message>
    <message>
        <source>The ICC profile is not of an RGB or CMYK printer, choose the printer&apos;s output profile</source>
        <translation>O perfil ICC não é de uma impressora RGB ou CMYK; escolha o perfil de saída da impressora</translation>
    </message>
</context>
<context>
    <name>dipwright::Printing</name>
    <message>
        <source>The printer does not say what it can do: %1</source>
        <translation>A impressora não diz o que pode fazer: %1</translation>
    </message>
    <message>
        <source>The printer does not take the job: %1</source>
        <translation>A impressora não aceita o trabalho: %1</translation>
    </message>
    <message>
        <source>The sheet could not be sent to the printer: %1</source>
        <translation>A folha não pôde ser enviada à impressora: %1</translation>
    </message>
    <message>
        <source>The print system does not tell what became of the job: %1</source>
        <translation>O sistema de impressão não diz o que foi feito do trabalho: %1</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>There is no such printer, and no other; set one up in the system first</source>
        <translation>Essa impressora não existe, nem outra; configure uma no sistema primeiro</translation>
    </message>
    <message>
        <source>There is no such printer, there are: %1</source>
        <translation>Essa impressora não existe; existem: %1</translation>
    </message>
    <message>
        <source>The printer is stopped%1; start it again in the system&apos;s settings</source>
        <translation>A impressora está parada%1; reinicie-a nas configurações do sistema</translation>
    </message>
    <message>
        <source>The printer takes no jobs at the moment%1; let it in the system&apos;s settings</source>
        <translation>A impressora não aceita trabalhos no momento%1; permita nas configurações do sistema</translation>
    </message>
    <message>
        <source>The printer has no paper of %1; set the sheet&apos;s paper to one that it has: %2</source>
        <translation>A impressora não tem papel de %1; ajuste o papel da folha para um que ela tenha: %2</translation>
    </message>
    <message>
        <source>The sheet of %1 is larger than every paper of the printer (%2); make it smaller or print it in tiles</source>
        <translation>A folha de %1 é maior que todo papel da impressora (%2); diminua-a ou imprima em pedaços</translation>
    </message>
    <message>
        <source>The printer names no paper to print pieces on</source>
        <translation>A impressora não indica papel para imprimir os pedaços</translation>
    </message>
    <message>
        <source>The printer has no paper named %1</source>
        <translation>A impressora não tem papel chamado %1</translation>
    </message>
    <message>
        <source>The printer does not reach the outer %1 mm of the paper, and the sheet has colour there</source>
        <translation>A impressora não alcança os %1 mm externos do papel, e a folha tem cor ali</translation>
    </message>
    <message>
        <source>%1; choose larger or borderless paper, or accept that it is lost</source>
        <translation>%1; escolha papel maior ou sem margens, ou aceite a perda</translation>
    </message>
    <message>
        <source>The printer prints in grey only, and the sheet is coloured; choose a colour printer, or accept grey</source>
        <translation>A impressora só imprime em cinza, e a folha é colorida; escolha uma impressora em cores, ou aceite cinza</translation>
    </message>
    <message>
        <source>The printer prints the coloured sheet in grey</source>
        <translation>A impressora imprime a folha colorida em cinza</translation>
    </message>
    <message>
        <source>The printer has no paper of %1 loaded</source>
        <translation>A impressora não tem papel de %1 carregado</translation>
    </message>
    <message>
        <source>%1; load it, or choose other paper</source>
        <translation>%1; carregue-o, ou escolha outro papel</translation>
    </message>
    <message>
        <source>Printing</source>
        <translation>Imprimindo</translation>
    </message>
    <message>
        <source>Held in the printer&apos;s queue</source>
        <translation>Retido na fila da impressora</translation>
    </message>
    <message>
        <source>Waiting in the printer&apos;s queue</source>
        <translation>Aguardando na fila da impressora</translation>
    </message>
    <message>
        <source>it does not say why</source>
        <translation>ela não diz por quê</translation>
    </message>
    <message>
        <source>The job was cancelled at the printer</source>
        <translation>O trabalho foi cancelado na impressora</translation>
    </message>
    <message>
        <source>The printer gave the job up: %1</source>
        <translation>A impressora desistiu do trabalho: %1</translation>
    </message>
    <message>
        <source>The printer stopped in the middle of the job: %1; the rest is cancelled, print the sheet anew</source>
        <translation>A impressora parou no meio do trabalho: %1; o resto foi cancelado, imprima a folha de novo</translation>
    </message>
    <message>
        <source>The printer has stopped: %1; the job is cancelled, start the printer and print the sheet anew</source>
        <translation>A impressora parou: %1; o trabalho foi cancelado, inicie a impressora e imprima a folha de novo</translation>
    </message>
    <message>
        <source>This program was built without printing; print the sheet&apos;s PDF at 100 % instead</source>
        <translation>Este programa foi feito sem impressão; imprima o PDF da folha a 100 %</translation>
    </message>
    <message>
        <source>The printer does not take the job</source>
        <translation>A impressora não aceita o trabalho</translation>
    </message>
    <message>
        <source>The sheet could not be sent to the printer</source>
        <translation>A folha não pôde ser enviada à impressora</translation>
    </message>
    <message>
        <source>The printer takes this paper only with its other edge first; turn the page</source>
        <translation>A impressora só aceita este papel com a outra borda primeiro; gire a página</translation>
    </message>
    <message>
        <source>The printer does not reach the outer %1 mm of the paper; put its margins into its profile first</source>
        <translation>A impressora não alcança os %1 mm externos do papel; ponha primeiro as margens no perfil dela</translation>
    </message>
    <message>
        <source>Calibration of %1</source>
        <translation>Calibração de %1</translation>
    </message>
    <message>
        <source>Pieces of a sheet are written as PDF, one page each; name the file .pdf</source>
        <translation>As partes de uma folha são gravadas como PDF, uma página cada; dê ao arquivo a extensão .pdf</translation>
    </message>
    <message>
        <source>The printer scales pages by itself (&quot;%1&quot;), and the print system does not pass on to it that it must not; set its scaling to &quot;none&quot; in its own menu</source>
        <translation>A impressora redimensiona páginas por si (&quot;%1&quot;), e o sistema de impressão não lhe repassa que não deve; ponha a escala em &quot;none&quot; no menu dela</translation>
    </message>
    <message>
        <source>%1, lot %2</source>
        <translation>%1, lote %2</translation>
    </message>
    <message>
        <source>Sent, nothing more is known</source>
        <translation>Enviado, nada mais se sabe</translation>
    </message>
    <message>
        <source>Printed</source>
        <translation>Impresso</translation>
    </message>
    <message>
        <source>Handed to the printer&apos;s queue</source>
        <translation>Entregue à fila da impressora</translation>
    </message>
    <message>
        <source>Written to a file</source>
        <translation>Gravado em um arquivo</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Cancelado</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Falhou: %1</translation>
    </message>
    <message>
        <source>The print history does not have it: %1</source>
        <translation>O histórico de impressão não o contém: %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>a pasta %1 não pode ser criada</translation>
    </message>
    <message>
        <source>it does not leave the page&apos;s size alone</source>
        <translation>ela não mantém o tamanho da página como está</translation>
    </message>
    <message>
        <source>The printer scales pages where it is not told otherwise, which its queue does not pass on; the job goes past the queue, to the printer itself</source>
        <translation>A impressora redimensiona páginas quando não lhe dizem o contrário, e a fila não repassa isso; o trabalho vai direto à impressora, sem passar pela fila</translation>
    </message>
    <message>
        <source>The white layer is left out: it needs a printer profile with an ICC profile in CMYK</source>
        <translation>A camada branca fica de fora: ela precisa de um perfil de impressora com um perfil ICC em CMYK</translation>
    </message>
    <message>
        <source>The cut line is left out: it needs a PDF and a printer profile with an ICC profile in CMYK</source>
        <translation>A linha de corte fica de fora: ela precisa de um PDF e de um perfil de impressora com um perfil ICC em CMYK</translation>
    </message>
    <message>
        <source>The spot inks are left out: they need a printer profile with an ICC profile in CMYK</source>
        <translation>As tintas especiais ficam de fora: precisam de um perfil de impressora com perfil ICC em CMYK</translation>
    </message>
    <message>
        <source>On %1 mm² of the part the inks fall visibly short: full ink, the ink limit or the total of ink does not make up for the stretch</source>
        <translation>Em %1 mm² da peça as tintas ficam visivelmente aquém: a tinta cheia, o limite de tinta ou o total de tinta não compensa o estiramento</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Parado: %1</translation>
    </message>
    <message>
        <source>Not known: %1</source>
        <translation>Não se sabe: %1</translation>
    </message>
    <message>
        <source>the job is cancelled</source>
        <translation>o trabalho foi cancelado</translation>
    </message>
    <message>
        <source>the job could not be cancelled, remove it from the printer&apos;s queue</source>
        <translation>não foi possível cancelar o trabalho, remova-o da fila da impressora</translation>
    </message>
    <message>
        <source>The print system has done with the job, but the printer does not answer; look whether the sheet has come out, and print it anew if not</source>
        <translation>O sistema de impressão concluiu o trabalho, mas a impressora não responde; verifique se a folha saiu e, se não, imprima-a de novo</translation>
    </message>
    <message>
        <source>The printer does not answer (%1); %2; check its power, its cable and its address in the system, and print the sheet anew</source>
        <translation>A impressora não responde (%1); %2; verifique a energia, o cabo e o endereço dela no sistema e imprima a folha de novo</translation>
    </message>
    <message>
        <source>Nothing new was heard of job %1 for a long time (%2), and this printer cannot be asked; look at the printer, and remove the job from its queue if it does not print</source>
        <translation>Há muito tempo não há novidade do trabalho %1 (%2), e não é possível perguntar a esta impressora; olhe a impressora e remova o trabalho da fila se ela não imprimir</translation>
    </message>
</context>
<context>
    <name>dipwright::ProfileController</name>
    <message>
        <source>Use Profile %1</source>
        <translation>Usar o perfil %1</translation>
    </message>
    <message>
        <source>Calibrated %1</source>
        <translation>%1 calibrado</translation>
    </message>
</context>
<context>
    <name>dipwright::ProfilesDialog</name>
    <message>
        <source>Profiles (%1)</source>
        <translation>Perfis (%1)</translation>
    </message>
    <message>
        <source>None: the printer is sent sRGB</source>
        <translation>Nenhum: a impressora recebe sRGB</translation>
    </message>
    <message>
        <source>%1 (RGB)</source>
        <translation>%1 (RGB)</translation>
    </message>
    <message>
        <source>Copy…</source>
        <translation>Copiar…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remover</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>&amp;Use in Project</source>
        <translation>&amp;Usar no projeto</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Perfis</translation>
    </message>
    <message>
        <source>The project takes its values over and keeps a copy, so that it prints the same when the profile has since changed.</source>
        <translation>O projeto assume seus valores e guarda uma cópia, para imprimir igual mesmo que o perfil mude depois.</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importar…</translation>
    </message>
    <message>
        <source>Makes a profile of your own from this one.</source>
        <translation>Cria um perfil seu a partir deste.</translation>
    </message>
    <message>
        <source>Printers</source>
        <translation>Impressoras</translation>
    </message>
    <message>
        <source>Films</source>
        <translation>Filmes</translation>
    </message>
    <message>
        <source>Tanks</source>
        <translation>Tanques</translation>
    </message>
    <message>
        <source>Comes with the program</source>
        <translation>Vem com o programa</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Escolher…</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nenhum</translation>
    </message>
    <message>
        <source>Choose an ICC profile</source>
        <translation>Escolher um perfil ICC</translation>
    </message>
    <message>
        <source>No ICC profile</source>
        <translation>Sem perfil ICC</translation>
    </message>
    <message>
        <source>ICC profile</source>
        <translation>Perfil ICC</translation>
    </message>
    <message>
        <source>The printer&apos;s output profile, made for its ink and film. Sheets are then sent in the printer&apos;s own colours.</source>
        <translation>O perfil de saída da impressora, feito para sua tinta e filme. As folhas são então enviadas nas cores da própria impressora.</translation>
    </message>
    <message>
        <source>A profile needs a name</source>
        <translation>Um perfil precisa de um nome</translation>
    </message>
    <message>
        <source>There is a profile of this name already, choose another</source>
        <translation>Já existe um perfil com este nome, escolha outro</translation>
    </message>
    <message>
        <source>Changes are kept at once. Profiles in italics come with the program; a changed one is yours, and Remove brings the first back.</source>
        <translation>As mudanças são guardadas na hora. Perfis em itálico vêm com o programa; um perfil mudado é seu, e Remover traz o original de volta.</translation>
    </message>
    <message>
        <source>Import Profile</source>
        <translation>Importar perfil</translation>
    </message>
    <message>
        <source>Export Profile</source>
        <translation>Exportar perfil</translation>
    </message>
    <message>
        <source>Copy Profile</source>
        <translation>Copiar perfil</translation>
    </message>
    <message>
        <source>Name of the copy:</source>
        <translation>Nome da cópia:</translation>
    </message>
    <message>
        <source>%1, own</source>
        <translation>%1, próprio</translation>
    </message>
    <message>
        <source>ICC profiles (%1)</source>
        <translation>Perfis ICC (%1)</translation>
    </message>
    <message>
        <source>Profile Changed Elsewhere</source>
        <translation>Perfil mudado em outro lugar</translation>
    </message>
    <message>
        <source>Another program has changed the profile “%1” meanwhile.</source>
        <translation>Outro programa mudou o perfil “%1” nesse meio-tempo.</translation>
    </message>
    <message>
        <source>Show the Other’s</source>
        <translation>Mostrar o do outro</translation>
    </message>
    <message>
        <source>Keep &amp;Mine</source>
        <translation>&amp;Manter o meu</translation>
    </message>
    <message>
        <source>%1 (CMYK)</source>
        <translation>%1 (CMYK)</translation>
    </message>
</context>
<context>
    <name>dipwright::ProjectTree</name>
    <message>
        <source>Project</source>
        <translation>Projeto</translation>
    </message>
    <message>
        <source>The result is up to date.</source>
        <translation>O resultado está atualizado.</translation>
    </message>
    <message>
        <source>Changed since the last run. Run again.</source>
        <translation>Mudou desde a última execução. Execute de novo.</translation>
    </message>
    <message>
        <source>Not simulated yet.</source>
        <translation>Ainda não simulado.</translation>
    </message>
    <message>
        <source>Add a second immersion</source>
        <translation>Adicionar uma segunda imersão</translation>
    </message>
    <message>
        <source>Remove this immersion</source>
        <translation>Remover esta imersão</translation>
    </message>
</context>
<context>
    <name>dipwright::PropertyField</name>
    <message>
        <source>%1 to %2%3</source>
        <translation>%1 a %2%3</translation>
    </message>
    <message>
        <source>linked</source>
        <translation>vinculado</translation>
    </message>
    <message>
        <source>Linked: typing one number sets the others as well</source>
        <translation>Vinculado: digitar um número define também os outros</translation>
    </message>
    <message>
        <source>Choose %1</source>
        <translation>Escolher %1</translation>
    </message>
    <message>
        <source>Choose the colour</source>
        <translation>Escolher a cor</translation>
    </message>
</context>
<context>
    <name>dipwright::PropertyPanel</name>
    <message>
        <source>Properties</source>
        <translation>Propriedades</translation>
    </message>
    <message>
        <source>Film profile</source>
        <translation>Perfil do filme</translation>
    </message>
    <message>
        <source>A film that was measured once: size, swell, relaxation and sides.</source>
        <translation>Um filme que foi medido uma vez: tamanho, inchamento, relaxação e lados.</translation>
    </message>
    <message>
        <source>Tank profile</source>
        <translation>Perfil do tanque</translation>
    </message>
    <message>
        <source>A tank: its barriers hold the film&apos;s sides.</source>
        <translation>Um tanque: suas barreiras prendem os lados do filme.</translation>
    </message>
    <message>
        <source>Printer profile</source>
        <translation>Perfil da impressora</translation>
    </message>
    <message>
        <source>A printer that was measured once: its scale, margins, colours, ink limit and resolution.</source>
        <translation>Uma impressora que foi medida uma vez: escala, margens, cores, limite de tinta e resolução.</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Mudar %1</translation>
    </message>
    <message>
        <source>Embedded in the project</source>
        <translation>Embutido no projeto</translation>
    </message>
    <message>
        <source>From %1</source>
        <translation>De %1</translation>
    </message>
    <message>
        <source>%1 × %2 × %3</source>
        <translation>%1 × %2 × %3</translation>
    </message>
    <message>
        <source>Triangles: %1</source>
        <translation>Triângulos: %1</translation>
    </message>
    <message>
        <source>Volume: %1 cm³</source>
        <translation>Volume: %1 cm³</translation>
    </message>
    <message>
        <source>Closed surface</source>
        <translation>Superfície fechada</translation>
    </message>
    <message>
        <source>Surface with openings</source>
        <translation>Superfície com aberturas</translation>
    </message>
    <message>
        <source>Texture of %1 × %2 pixels</source>
        <translation>Textura de %1 × %2 pixels</translation>
    </message>
    <message>
        <source>No texture: drop a picture on the window to put one on</source>
        <translation>Sem textura: solte uma imagem na janela para aplicar uma</translation>
    </message>
    <message>
        <source>Reload from Disk</source>
        <translation>Recarregar do disco</translation>
    </message>
    <message>
        <source>Reads the model&apos;s file again and keeps all settings.</source>
        <translation>Lê de novo o arquivo do modelo e mantém as configurações.</translation>
    </message>
    <message>
        <source>Replace Model…</source>
        <translation>Trocar modelo…</translation>
    </message>
    <message>
        <source>Takes another model. Rotations and offsets start anew.</source>
        <translation>Usa outro modelo. Rotações e deslocamentos recomeçam.</translation>
    </message>
    <message>
        <source>Replace Texture…</source>
        <translation>Trocar textura…</translation>
    </message>
    <message>
        <source>Puts another picture on the model.</source>
        <translation>Põe outra imagem no modelo.</translation>
    </message>
    <message>
        <source>Production</source>
        <translation>Produção</translation>
    </message>
    <message>
        <source>Paper of 2020</source>
        <translation>Artigo de 2020</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizado</translation>
    </message>
    <message>
        <source>Production is the accurate film model and the default. Paper of 2020 is the published model, for comparison.</source>
        <translation>Produção é o modelo de filme preciso e o padrão. Artigo de 2020 é o modelo publicado, para comparação.</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Predefinição</translation>
    </message>
    <message>
        <source>Apply Preset</source>
        <translation>Aplicar predefinição</translation>
    </message>
    <message>
        <source>Choose %1</source>
        <translation>Escolher %1</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nenhum</translation>
    </message>
    <message>
        <source>Best available</source>
        <translation>Melhor disponível</translation>
    </message>
    <message>
        <source>%1 (not available)</source>
        <translation>%1 (não disponível)</translation>
    </message>
    <message>
        <source>What computes the dip. “Best available” takes a GPU where there is one.</source>
        <translation>O que calcula a imersão. “Melhor disponível” usa uma GPU onde houver.</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solucionador</translation>
    </message>
    <message>
        <source>Choose Solver</source>
        <translation>Escolher solucionador</translation>
    </message>
    <message>
        <source>%1 (not installed)</source>
        <translation>%1 (não instalado)</translation>
    </message>
    <message>
        <source>Where the join runs</source>
        <translation>Por onde passa a junção</translation>
    </message>
    <message>
        <source>Shown with “Print on the Body”; changes no sheet.</source>
        <translation>Visto com “Impressão no corpo”; não muda folha alguma.</translation>
    </message>
    <message>
        <source>The print, and if the second film lies off</source>
        <translation>A impressão, e se o segundo filme desvia</translation>
    </message>
    <message>
        <source>Zones on the body</source>
        <translation>Zonas no corpo</translation>
    </message>
    <message>
        <source>Tell Tolerances…</source>
        <translation>Calcular tolerâncias…</translation>
    </message>
    <message>
        <source>Dips with everything off, one by one and all at once, and says how far the colours land off their places.</source>
        <translation>Mergulha com todos os desvios, um a um e todos juntos, e diz quanto as cores caem fora do lugar.</translation>
    </message>
    <message>
        <source>Longest edge</source>
        <translation>Aresta mais longa</translation>
    </message>
    <message>
        <source>Makes the body larger or smaller, with what is marked on it.</source>
        <translation>Torna o corpo maior ou menor, com o que está marcado nele.</translation>
    </message>
</context>
<context>
    <name>dipwright::QueueDialog</name>
    <message>
        <source>Waiting</source>
        <translation>Aguardando</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Em execução</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Concluído</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Falhou</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Cancelado</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Job Queue</source>
        <translation>Fila de trabalhos</translation>
    </message>
    <message>
        <source>Projects in the queue</source>
        <translation>Projetos na fila</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projeto</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Folder for the results</source>
        <translation>Pasta dos resultados</translation>
    </message>
    <message>
        <source>Each project that is added has a folder with its name in this one.</source>
        <translation>Cada projeto adicionado tem nesta uma pasta com seu nome.</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>&amp;Escolher…</translation>
    </message>
    <message>
        <source>Results &amp;into</source>
        <translation>Resultados e&amp;m</translation>
    </message>
    <message>
        <source>&amp;Add Projects…</source>
        <translation>&amp;Adicionar projetos…</translation>
    </message>
    <message>
        <source>&amp;Cancel Chosen</source>
        <translation>&amp;Cancelar escolhidos</translation>
    </message>
    <message>
        <source>Cancel A&amp;ll</source>
        <translation>Cancelar &amp;todos</translation>
    </message>
    <message>
        <source>&amp;Remove Ended</source>
        <translation>&amp;Remover terminados</translation>
    </message>
    <message>
        <source>&amp;Open Project</source>
        <translation>A&amp;brir projeto</translation>
    </message>
    <message>
        <source>Add Projects</source>
        <translation>Adicionar projetos</translation>
    </message>
    <message>
        <source>Folder for the Results</source>
        <translation>Pasta dos resultados</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1
Results: %2</source>
        <translation>%1
Resultados: %2</translation>
    </message>
    <message>
        <source>Add projects: they are run one after the other as they are saved, and their results written.</source>
        <translation>Adicione projetos: eles são executados um depois do outro, como estão salvos, e seus resultados, escritos.</translation>
    </message>
    <message>
        <source>%1 of %2 ended</source>
        <translation>%1 de %2 terminados</translation>
    </message>
    <message>
        <source>, about %1 left</source>
        <translation>, faltam cerca de %1</translation>
    </message>
    <message>
        <source>Projects are still being run. Stop them?</source>
        <translation>Ainda há projetos em execução. Parar?</translation>
    </message>
    <message>
        <source>What is done is kept.</source>
        <translation>O que está concluído fica.</translation>
    </message>
    <message>
        <source>&amp;Stop Them</source>
        <translation>&amp;Parar</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duração</translation>
    </message>
</context>
<context>
    <name>dipwright::ReadPhotos</name>
    <message>
        <source>The photo cannot be read; check its name and permissions</source>
        <translation>A foto não pode ser lida; verifique o nome e as permissões</translation>
    </message>
</context>
<context>
    <name>dipwright::Reader</name>
    <message>
        <source>The program that reads models and pictures cannot be kept from doing anything else on this system, and does not read; use another system, or set DIPWRIGHT_READ_UNCONFINED=1 for files that you trust</source>
        <translation>O programa que lê modelos e imagens não pode ser impedido de fazer outra coisa neste sistema, e não lê; use outro sistema, ou defina DIPWRIGHT_READ_UNCONFINED=1 para arquivos em que você confia</translation>
    </message>
</context>
<context>
    <name>dipwright::ReaderProcess</name>
    <message>
        <source>The program that reads models and pictures is missing; install Dipwright anew</source>
        <translation>O programa que lê modelos e imagens está faltando; reinstale o Dipwright</translation>
    </message>
    <message>
        <source>The program that reads models and pictures cannot be started: %1</source>
        <translation>O programa que lê modelos e imagens não pode ser iniciado: %1</translation>
    </message>
    <message>
        <source>The file makes its reader hand back what cannot be, and is not read; save it anew</source>
        <translation>O arquivo faz seu leitor devolver o que não pode ser e não é lido; salve-o de novo</translation>
    </message>
    <message>
        <source>The file makes its reader crash and is not read; save it anew, a model as %1, a picture as PNG</source>
        <translation>O arquivo faz seu leitor falhar e não é lido; salve-o de novo, um modelo como %1, uma imagem como PNG</translation>
    </message>
    <message>
        <source>en</source>
        <extracomment>The code of the language of this translation: de, pt_BR …</extracomment>
        <translation>pt_BR</translation>
    </message>
</context>
<context>
    <name>dipwright::ReportPanel</name>
    <message>
        <source>Report</source>
        <translation>Relatório</translation>
    </message>
    <message>
        <source>Run the dip to see its figures.</source>
        <translation>Execute a imersão para ver seus números.</translation>
    </message>
    <message>
        <source>Body painted altogether</source>
        <translation>Corpo pintado ao todo</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solucionador</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Dispositivo</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolerâncias</translation>
    </message>
    <message>
        <source>Film used</source>
        <translation>Filme usado</translation>
    </message>
</context>
<context>
    <name>dipwright::Results</name>
    <message>
        <source>There is no colour map of this name; choose one of %1</source>
        <translation>Não há mapa de cores com este nome; escolha um de %1</translation>
    </message>
    <message>
        <source>Preparing the proof</source>
        <translation>Preparando a prova</translation>
    </message>
    <message>
        <source>Tracing the proof</source>
        <translation>Traçando a prova</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Direita</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Trás</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Esquerda</translation>
    </message>
    <message>
        <source>Stretch of the film</source>
        <translation>Estiramento do filme</translation>
    </message>
    <message>
        <source>Mean of each point&apos;s constraints, final over rest length; ink side up</source>
        <translation>Média das restrições de cada ponto, comprimento final sobre o de repouso; lado da tinta para cima</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>stretch
mm per mm</source>
        <translation>estiramento
mm por mm</translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation>%1 e mais</translation>
    </message>
    <message>
        <source>On the body: min %1 · mean %2 · 95 % %3 · max %4</source>
        <translation>No corpo: mín %1 · média %2 · 95 % %3 · máx %4</translation>
    </message>
    <message>
        <source>Outlined: film on the body · pale: film left over</source>
        <translation>Contornado: filme no corpo · pálido: filme restante</translation>
    </message>
    <message>
        <source>Wrinkling of the film</source>
        <translation>Enrugamento do filme</translation>
    </message>
    <message>
        <source>Smaller principal stretch; below 1 the film is compressed and may fold</source>
        <translation>Menor estiramento principal; abaixo de 1 o filme está comprimido e pode dobrar</translation>
    </message>
    <message>
        <source>On the body: compressed by over 1 % on %1 % of the film · smallest stretch %2</source>
        <translation>No corpo: comprimido em mais de 1 % em %1 % do filme · menor estiramento %2</translation>
    </message>
    <message>
        <source>Certainty of the sheet</source>
        <translation>Confiabilidade da folha</translation>
    </message>
    <message>
        <source>more</source>
        <translation>mais</translation>
    </message>
    <message>
        <source>%1: %2 mm², %3 %</source>
        <translation>%1: %2 mm², %3 %</translation>
    </message>
    <message>
        <source>Both, along the join</source>
        <translation>Ambas, ao longo da junção</translation>
    </message>
    <message>
        <source>Not reached</source>
        <translation>Não alcançado</translation>
    </message>
    <message>
        <source>The join: %1 mm</source>
        <translation>A junção: %1 mm</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>De cima</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>De baixo</translation>
    </message>
    <message>
        <source>Tracing the shares</source>
        <translation>Traçando as partes</translation>
    </message>
    <message>
        <source>Film of %1</source>
        <translation>Filme de %1</translation>
    </message>
    <message>
        <source>Tolerance of the sheet</source>
        <translation>Tolerância da folha</translation>
    </message>
    <message>
        <source>How far the ink may land off its place on the body; ink side up</source>
        <translation>Quanto a tinta pode cair fora do lugar no corpo; lado da tinta para cima</translation>
    </message>
    <message>
        <source>in</source>
        <translation>pol</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>a number and its unit</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>change
%1</source>
        <translation>mudança
%1</translation>
    </message>
    <message>
        <source>off by
± %1</source>
        <translation>desvio
± %1</translation>
    </message>
    <message>
        <source>On the body: 95 % within ±%1</source>
        <translation>No corpo: 95 % dentro de ±%1</translation>
    </message>
    <message>
        <source>Numerical error of the ink&apos;s position; ink side up</source>
        <translation>Erro numérico da posição da tinta; lado da tinta para cima</translation>
    </message>
    <message>
        <source>Limit: %1 · magenta: painted in only one of the dips</source>
        <translation>Limite: %1 · magenta: pintado em só uma das imersões</translation>
    </message>
</context>
<context>
    <name>dipwright::ResultsPanel</name>
    <message>
        <source>Reverse texture</source>
        <translation>Textura reversa</translation>
    </message>
    <message>
        <source>Run the dip to see the image that goes on the film.</source>
        <translation>Execute a imersão para ver a imagem que vai no filme.</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Prova</translation>
    </message>
    <message>
        <source>Run the dip to see the body as it will come out.</source>
        <translation>Execute a imersão para ver o corpo como sairá.</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Folha</translation>
    </message>
    <message>
        <source>Run the dip to see the page as it prints.</source>
        <translation>Execute a imersão para ver a página como será impressa.</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Estiramento</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textura</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Relatório</translation>
    </message>
    <message>
        <source>How much the film has stretched, and where</source>
        <translation>Quanto o filme esticou, e onde</translation>
    </message>
    <message>
        <source>The reverse texture: the image that goes on the film</source>
        <translation>A textura reversa: a imagem que vai no filme</translation>
    </message>
    <message>
        <source>The body as it will come out</source>
        <translation>O corpo como sairá</translation>
    </message>
    <message>
        <source>The page as it prints</source>
        <translation>A página como será impressa</translation>
    </message>
    <message>
        <source>The figures of the last run</source>
        <translation>Os números da última execução</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredito</translation>
    </message>
    <message>
        <source>Whether to print the sheet, and where to look first</source>
        <translation>Se a folha deve ser impressa e onde olhar antes</translation>
    </message>
    <message>
        <source>Who Paints What</source>
        <translation>Quem pinta o quê</translation>
    </message>
    <message>
        <source>The shares of the two dips, from six sides and on both films</source>
        <translation>As partes das duas imersões, de seis lados e nos dois filmes</translation>
    </message>
    <message>
        <source>The shares of the two dips, over the sheet of this one</source>
        <translation>As partes das duas imersões, sobre a folha desta</translation>
    </message>
    <message>
        <source>Without White</source>
        <translation>Sem branco</translation>
    </message>
    <message>
        <source>The ink on the part&apos;s own colour, as it were without the white</source>
        <translation>A tinta sobre a cor da própria peça, como seria sem o branco</translation>
    </message>
</context>
<context>
    <name>dipwright::ReverseTexture</name>
    <message>
        <source>Reversing the texture</source>
        <translation>Revertendo a textura</translation>
    </message>
    <message>
        <source>The film&apos;s image is too large for this computer&apos;s memory; choose a lower resolution</source>
        <translation>A imagem do filme é grande demais para a memória deste computador; escolha uma resolução menor</translation>
    </message>
    <message>
        <source>Continuing the colour past the edge</source>
        <translation>Continuando a cor além da borda</translation>
    </message>
</context>
<context>
    <name>dipwright::SearchController</name>
    <message>
        <source>Searching poses</source>
        <translation>Procurando poses</translation>
    </message>
    <message>
        <source>The poses are searched; the best is on top.</source>
        <translation>As poses foram procuradas; a melhor está no alto.</translation>
    </message>
    <message>
        <source>The search was stopped; the best so far is on top.</source>
        <translation>A busca foi encerrada; a melhor até agora está no alto.</translation>
    </message>
    <message>
        <source>Pose Search</source>
        <translation>Busca de poses</translation>
    </message>
    <message>
        <source>Change What Poses Are Searched For</source>
        <translation>Alterar o que se busca nas poses</translation>
    </message>
</context>
<context>
    <name>dipwright::SearchPage</name>
    <message>
        <source>&amp;Search</source>
        <translation>&amp;Procurar</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausar</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Encerrar</translation>
    </message>
    <message>
        <source>&amp;Take This Pose</source>
        <translation>&amp;Assumir esta pose</translation>
    </message>
    <message>
        <source>One dip</source>
        <translation>Uma imersão</translation>
    </message>
    <message>
        <source>Two dips, judged together</source>
        <translation>Duas imersões, julgadas juntas</translation>
    </message>
    <message>
        <source> poses</source>
        <translation> poses</translation>
    </message>
    <message>
        <source>How many poses are dipped with a coarse film, out of %1 that are judged by the body&apos;s shape. The best are refined.</source>
        <translation>Quantas poses são mergulhadas com um filme grosso, de %1 que são julgadas pela forma do corpo. As melhores são refinadas.</translation>
    </message>
    <message>
        <source>The same number gives the same table; another one tries other directions.</source>
        <translation>O mesmo número dá a mesma tabela; outro experimenta outras direções.</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planejar</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Experimentar</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semente</translation>
    </message>
    <message>
        <source>What counts, and what must be kept</source>
        <translation>O que conta e o que deve ser mantido</translation>
    </message>
    <message>
        <source>Let others have the processor; the search goes on where it was</source>
        <translation>Deixa o processador para outros; a busca continua de onde estava</translation>
    </message>
    <message>
        <source>End the search and keep the best that was found</source>
        <translation>Encerra a busca e guarda o melhor que foi encontrado</translation>
    </message>
    <message>
        <source>Progress of the search</source>
        <translation>Progresso da busca</translation>
    </message>
    <message>
        <source>The project has been changed since these poses were searched.</source>
        <translation>O projeto foi alterado desde que estas poses foram procuradas.</translation>
    </message>
    <message>
        <source>Dip the body as chosen in the table; one step to undo</source>
        <translation>Mergulha o corpo como escolhido na tabela; um passo a desfazer</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>%1 of %2 dips</source>
        <translation>%1 de %2 imersões</translation>
    </message>
    <message>
        <source>%1, about %2 s left</source>
        <translation>%1, restam cerca de %2 s</translation>
    </message>
    <message>
        <source>Rank %1 against rank %2: %3</source>
        <translation>Posição %1 contra posição %2: %3</translation>
    </message>
    <message>
        <source>Side &amp;by Side …</source>
        <translation>La&amp;do a lado …</translation>
    </message>
    <message>
        <source>Two chosen poses, or one and the project&apos;s own, in the view, by cameras that turn together</source>
        <translation>Duas poses escolhidas, ou uma e a do projeto, na vista, com câmeras que giram juntas</translation>
    </message>
    <message>
        <source>Rank %1</source>
        <translation>Posição %1</translation>
    </message>
    <message>
        <source>The project&apos;s own</source>
        <translation>A do projeto</translation>
    </message>
</context>
<context>
    <name>dipwright::Sheet</name>
    <message>
        <source>A film of %1 × %2 mm at %3 dpi does not make an image of 1 to %4 pixels a side; choose another resolution or film size</source>
        <translation>Um filme de %1 × %2 mm a %3 dpi não dá uma imagem de 1 a %4 pixels por lado; escolha outra resolução ou tamanho de filme</translation>
    </message>
    <message>
        <source>The sheet&apos;s PDF cannot be written: %1</source>
        <translation>O PDF da folha não pode ser gravado: %1</translation>
    </message>
    <message>
        <source>The sheet&apos;s TIFF cannot be written: %1</source>
        <translation>O TIFF da folha não pode ser gravado: %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Unknown paper &quot;%1&quot;; choose film, A4, A3, Letter or custom</source>
        <translation>Papel “%1” desconhecido; escolha film, A4, A3, Letter ou custom</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 · Film %4 · Scale %5 · Job %6</source>
        <translation>%1 · %2 · %3 · Filme %4 · Escala %5 · Trabalho %6</translation>
    </message>
    <message>
        <source>%1 · Job %2</source>
        <translation>%1 · Trabalho %2</translation>
    </message>
    <message>
        <source>The paper of %1 × %2 mm is smaller than the film of %3 × %4 mm; choose larger paper, turn it or make the film smaller</source>
        <translation>O papel de %1 × %2 mm é menor que o filme de %3 × %4 mm; escolha papel maior, gire-o ou diminua o filme</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm leaves no room for pieces of the sheet; take larger paper</source>
        <translation>Papel de %1 × %2 mm não deixa espaço para pedaços da folha; use papel maior</translation>
    </message>
    <message>
        <source>The sheet would be cut into more than %1 pieces; take larger paper</source>
        <translation>A folha seria cortada em mais de %1 pedaços; use papel maior</translation>
    </message>
    <message>
        <source>%1 · row %2 of %3, column %4 of %5 · cut along the dashes</source>
        <translation>%1 · linha %2 de %3, coluna %4 de %5 · corte nos tracejados</translation>
    </message>
    <message>
        <source>Its sheet has %1 dpi and that of %2 has %3; give them one resolution</source>
        <translation>Sua folha tem %1 dpi e a de %2 tem %3; dê a ambas a mesma resolução</translation>
    </message>
    <message>
        <source>%1 pieces are to be packed; choose 1 to %2</source>
        <translation>%1 peças devem ser agrupadas; escolha de 1 a %2</translation>
    </message>
    <message>
        <source>With its marks it takes %1 × %2 mm, and the film leaves %3 × %4 mm within its edges; take a larger film</source>
        <translation>Com suas marcas ocupa %1 × %2 mm, e o filme deixa %3 × %4 mm dentro de suas bordas; use um filme maior</translation>
    </message>
    <message>
        <source>Film %1 of %2, pieces: %3</source>
        <translation>Filme %1 de %2, peças: %3</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>There is no ink on its sheet</source>
        <translation>Não há tinta em sua folha</translation>
    </message>
    <message>
        <source>This takes %1 films; choose fewer copies, up to %2 films</source>
        <translation>Isso requer %1 filmes; escolha menos cópias, até %2 filmes</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>Trabalho %1</translation>
    </message>
    <message>
        <source>Dip %1, copy %2 of %3</source>
        <translation>Imersão %1, cópia %2 de %3</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 · Film %4 · Scale %5</source>
        <translation>%1 · %2 · %3 · Filme %4 · Escala %5</translation>
    </message>
    <message>
        <source>Its white is printed otherwise than that of %1; give them one kind of white and one name for it</source>
        <translation>Seu branco é impresso de outro modo que o de %1; dê a ambos um só tipo de branco e um só nome para ele</translation>
    </message>
    <message>
        <source>Its spot ink %1 is printed otherwise than that of another job; give them one colour and order</source>
        <translation>A sua tinta especial %1 é impressa de outro modo que a de outro trabalho; dê-lhes uma só cor e ordem</translation>
    </message>
</context>
<context>
    <name>dipwright::SheetCorrection</name>
    <message>
        <source>Blue: what the next sheet is corrected by</source>
        <translation>Azul: em quanto a próxima folha é corrigida</translation>
    </message>
    <message>
        <source>Dip %1: %2 places on one part, off by up to %3 mm. What of this repeats is told by three parts or more.</source>
        <translation>Imersão %1: %2 lugares em uma peça, desviados em até %3 mm. O que disso se repete é dito por três peças ou mais.</translation>
    </message>
    <message>
        <source>Dip %1: %2 places on %3 parts. Up to %4 mm repeat, much the same within %5 mm; a place scatters by %6 mm, a whole part by %7 mm.</source>
        <translation>Imersão %1: %2 lugares em %3 peças. Até %4 mm se repetem, quase iguais dentro de %5 mm; um lugar varia em %6 mm, uma peça inteira em %7 mm.</translation>
    </message>
    <message>
        <source>Red: how far off, the mean of parts measured (%1), %2 times as long</source>
        <translation>Vermelho: o desvio, média das peças medidas (%1), %2 vezes maior</translation>
    </message>
</context>
<context>
    <name>dipwright::SnapshotsDialog</name>
    <message>
        <source>&amp;Take Snapshot</source>
        <translation>&amp;Tirar instantâneo</translation>
    </message>
    <message>
        <source>&amp;Go Back to It</source>
        <translation>&amp;Voltar a ele</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Remover</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>Instantâneos</translation>
    </message>
    <message>
        <source>Snapshots, the oldest first</source>
        <translation>Instantâneos, os mais antigos primeiro</translation>
    </message>
    <message>
        <source>Name of the snapshot</source>
        <translation>Nome do instantâneo</translation>
    </message>
    <message>
        <source>Under which the project&apos;s settings are kept in its file</source>
        <translation>Sob o qual as definições do projeto são guardadas em seu arquivo</translation>
    </message>
    <message>
        <source>Compared with</source>
        <translation>Comparado com</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>O que difere</translation>
    </message>
    <message>
        <source>The settings become those of the snapshot: a step that can be undone. Model, photos and parts stay.</source>
        <translation>As definições passam a ser as do instantâneo: um passo que pode ser desfeito. Modelo, fotos e peças ficam.</translation>
    </message>
    <message>
        <source>Compared with the project as it is now</source>
        <translation>Comparado com o projeto como está agora</translation>
    </message>
    <message>
        <source>Compared with %1</source>
        <translation>Comparado com %1</translation>
    </message>
    <message>
        <source>A snapshot keeps the project&apos;s settings under a name, in its file.</source>
        <translation>Um instantâneo guarda as definições do projeto sob um nome, em seu arquivo.</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Definição</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Agora</translation>
    </message>
    <message>
        <source>All settings are the same.</source>
        <translation>Todas as definições são iguais.</translation>
    </message>
    <message>
        <source>Settings that differ: %1</source>
        <translation>Definições que diferem: %1</translation>
    </message>
    <message>
        <source>&amp;Side by Side …</source>
        <translation>&amp;Lado a lado …</translation>
    </message>
    <message>
        <source>Both in the view, by cameras that turn together; what is not dipped yet is dipped</source>
        <translation>Ambos na vista, com câmeras que giram juntas; o que ainda não foi mergulhado é mergulhado</translation>
    </message>
</context>
<context>
    <name>dipwright::SolverPage</name>
    <message>
        <source>Solvers</source>
        <translation>Solucionadores</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solucionador</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Versão</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Dispositivo</translation>
    </message>
    <message>
        <source>%1 by %2
%3</source>
        <translation>%1 de %2
%3</translation>
    </message>
    <message>
        <source>None found</source>
        <translation>Nenhum encontrado</translation>
    </message>
    <message>
        <source>Put solver plugins into %1</source>
        <translation>Ponha plugins de solucionador em %1</translation>
    </message>
    <message>
        <source>Each project chooses its solver under Dipping. “Best available” takes the best that can run here.</source>
        <translation>Cada projeto escolhe seu solucionador em Imersão. “Melhor disponível” usa o melhor que possa rodar aqui.</translation>
    </message>
    <message>
        <source>Looking whether it can run here …</source>
        <translation>Verificando se pode rodar aqui …</translation>
    </message>
</context>
<context>
    <name>dipwright::StartPage</name>
    <message>
        <source>Recent projects</source>
        <translation>Projetos recentes</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Exemplos</translation>
    </message>
    <message>
        <source>Projects that you open or save appear here.</source>
        <translation>Projetos que você abrir ou salvar aparecem aqui.</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>Remover desta lista</translation>
    </message>
    <message>
        <source>From a textured model to a film that can be printed.</source>
        <translation>Do modelo texturizado ao filme pronto para imprimir.</translation>
    </message>
    <message>
        <source>New Project…</source>
        <translation>Novo projeto…</translation>
    </message>
    <message>
        <source>Open Project…</source>
        <translation>Abrir projeto…</translation>
    </message>
    <message>
        <source>Continue with a project that was saved.</source>
        <translation>Continue um projeto salvo.</translation>
    </message>
    <message>
        <source>Quick Tour</source>
        <translation>Visita rápida</translation>
    </message>
    <message>
        <source>What is where, in six steps.</source>
        <translation>O que está onde, em seis passos.</translation>
    </message>
    <message>
        <source>Models and projects can also be dropped on the window.</source>
        <translation>Modelos e projetos também podem ser soltos na janela.</translation>
    </message>
    <message>
        <source>Start from a textured model: %1.</source>
        <translation>Comece de um modelo texturizado: %1.</translation>
    </message>
</context>
<context>
    <name>dipwright::StatusLine</name>
    <message>
        <source>Value under the cursor</source>
        <translation>Valor sob o cursor</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progresso</translation>
    </message>
    <message>
        <source>It does not stop. Save your work; closing the window ends it.</source>
        <translation>Não para. Salve seu trabalho; fechar a janela encerra isso.</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Aviso</translation>
    </message>
</context>
<context>
    <name>dipwright::StretchPanel</name>
    <message>
        <source>Automatic range</source>
        <translation>Faixa automática</translation>
    </message>
    <message>
        <source>Lowest value</source>
        <translation>Menor valor</translation>
    </message>
    <message>
        <source>Highest value</source>
        <translation>Maior valor</translation>
    </message>
    <message>
        <source>Mark above</source>
        <translation>Marcar acima de</translation>
    </message>
    <message>
        <source>Limit above which film is marked</source>
        <translation>Limite acima do qual o filme é marcado</translation>
    </message>
    <message>
        <source>Isolines</source>
        <translation>Isolinhas</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Estiramento</translation>
    </message>
    <message>
        <source>Area stretch</source>
        <translation>Estiramento de área</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Maior estiramento</translation>
    </message>
    <message>
        <source>Smallest stretch</source>
        <translation>Menor estiramento</translation>
    </message>
    <message>
        <source>Length of the film&apos;s threads after the dip over before: the mean round each point.</source>
        <translation>Comprimento dos fios do filme depois sobre antes da imersão: a média em volta de cada ponto.</translation>
    </message>
    <message>
        <source>Area after over before. Ink thins by as much.</source>
        <translation>Área depois sobre antes. A tinta afina na mesma medida.</translation>
    </message>
    <message>
        <source>The stretch in the direction in which it is largest.</source>
        <translation>O estiramento na direção em que é maior.</translation>
    </message>
    <message>
        <source>The stretch in the direction in which it is smallest. Below 1 the film wrinkles.</source>
        <translation>O estiramento na direção em que é menor. Abaixo de 1 o filme enruga.</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Grandeza</translation>
    </message>
    <message>
        <source>Colour map</source>
        <translation>Mapa de cores</translation>
    </message>
    <message>
        <source>Colour map; all are safe for colour-blind readers.</source>
        <translation>Mapa de cores; todos são seguros para daltônicos.</translation>
    </message>
    <message>
        <source>Stretch map</source>
        <translation>Mapa de estiramento</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Save the map or its numbers</source>
        <translation>Salva o mapa ou seus números</translation>
    </message>
    <message>
        <source>Picture (PNG)…</source>
        <translation>Imagem (PNG)…</translation>
    </message>
    <message>
        <source>Table (CSV)…</source>
        <translation>Tabela (CSV)…</translation>
    </message>
    <message>
        <source>Film (VTP)…</source>
        <translation>Filme (VTP)…</translation>
    </message>
    <message>
        <source>Run the dip to see how the film stretches.</source>
        <translation>Execute a imersão para ver como o filme estica.</translation>
    </message>
    <message>
        <source>On the body: mean %1 · 95 % below %2 · largest %3</source>
        <translation>No corpo: média %1 · 95 % abaixo de %2 · maior %3</translation>
    </message>
    <message>
        <source>What the map shows.</source>
        <translation>O que o mapa mostra.</translation>
    </message>
    <message>
        <source>The colours span what occurs on the body. Without it they span the two numbers on the right, so that maps can be compared.</source>
        <translation>As cores abrangem o que ocorre no corpo. Sem isto, abrangem os dois números à direita, para que mapas possam ser comparados.</translation>
    </message>
    <message>
        <source>Shows all film over the limit in one warning colour.</source>
        <translation>Mostra todo o filme acima do limite em uma cor de aviso.</translation>
    </message>
    <message>
        <source>Lines of equal value on the map.</source>
        <translation>Linhas de mesmo valor no mapa.</translation>
    </message>
</context>
<context>
    <name>dipwright::SurfaceQuery</name>
    <message>
        <source>The mesh is too large for this computer&apos;s memory; reduce its number of triangles</source>
        <translation>A malha é grande demais para a memória deste computador; reduza o número de triângulos</translation>
    </message>
</context>
<context>
    <name>dipwright::Texture</name>
    <message>
        <source>The picture has no pixels; choose another one</source>
        <translation>A imagem não tem pixels; escolha outra</translation>
    </message>
    <message>
        <source>The file is not a picture that can be read; save it as PNG or JPEG</source>
        <translation>O arquivo não é uma imagem legível; salve-a como PNG ou JPEG</translation>
    </message>
    <message>
        <source>The picture is damaged: %1; save it anew</source>
        <translation>A imagem está danificada: %1; salve-a de novo</translation>
    </message>
    <message>
        <source>%1, with %2 × %3 pixels</source>
        <translation>%1, com %2 × %3 pixels</translation>
    </message>
    <message>
        <source>The picture&apos;s ICC profile is damaged or not for its pixels; save it anew, as sRGB</source>
        <translation>O perfil ICC da imagem está danificado ou não é para os seus pixels; salve-a de novo, como sRGB</translation>
    </message>
    <message>
        <source>The picture in CMYK is damaged, or kept in a way that is not read; save it anew as JPEG, or as TIFF without tiles and planes</source>
        <translation>A imagem em CMYK está danificada ou guardada de um modo que não é lido; salve-a de novo como JPEG, ou como TIFF sem blocos e planos</translation>
    </message>
    <message>
        <source>The picture is damaged: its ICC profile is cut off; save it anew</source>
        <translation>A imagem está danificada: seu perfil ICC foi cortado; salve-a de novo</translation>
    </message>
    <message>
        <source>Pictures in HEIF are not read here; save it as JPEG, or let the camera write JPEG</source>
        <translation>Imagens em HEIF não são lidas aqui; salve-a como JPEG, ou faça a câmera gravar JPEG</translation>
    </message>
    <message>
        <source>The picture&apos;s ICC profile is larger than %1 MB; save it anew, as sRGB</source>
        <translation>O perfil ICC da imagem é maior que %1 MB; salve-a novamente, como sRGB</translation>
    </message>
    <message>
        <source>The picture is cut off before its end; save it anew, or copy it again from where it came</source>
        <translation>A imagem está cortada antes do fim; salve-a novamente ou copie-a outra vez de onde veio</translation>
    </message>
    <message>
        <source>The photo is cut off in the middle; copy it from the camera again</source>
        <translation>A foto está cortada no meio; copie-a de novo da câmera</translation>
    </message>
    <message>
        <source>The picture in Lab is damaged, or kept in a way that is not read; save it anew as RGB, or as TIFF in 8 or 16 bits without tiles and planes</source>
        <translation>A imagem em Lab está danificada ou guardada de um modo que não é lido; salve-a de novo como RGB, ou como TIFF em 8 ou 16 bits sem blocos e planos</translation>
    </message>
</context>
<context>
    <name>dipwright::TexturedMesh</name>
    <message>
        <source>The model&apos;s texture</source>
        <translation>A textura do modelo</translation>
    </message>
    <message>
        <source>Texture %1 of the model</source>
        <translation>Textura %1 do modelo</translation>
    </message>
</context>
<context>
    <name>dipwright::Timeline</name>
    <message>
        <source>Before the dip</source>
        <translation>Antes da imersão</translation>
    </message>
    <message>
        <source>Play the dip</source>
        <translation>Reproduz a imersão</translation>
    </message>
    <message>
        <source>End of the dip</source>
        <translation>Fim da imersão</translation>
    </message>
    <message>
        <source>Time of the dip</source>
        <translation>Tempo da imersão</translation>
    </message>
    <message>
        <source>How far the lowest point of the body is under the waterline</source>
        <translation>Quanto o ponto mais baixo do corpo está abaixo da linha d&apos;água</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausar</translation>
    </message>
</context>
<context>
    <name>dipwright::ToleranceCheck</name>
    <message>
        <source>Telling the tolerances</source>
        <translation>Calculando as tolerâncias</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolerâncias</translation>
    </message>
</context>
<context>
    <name>dipwright::ToleranceDialog</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Off by</source>
        <translation>Desvio</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>Half</source>
        <translation>Metade</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Borda</translation>
    </message>
    <message>
        <source>What each contributor does</source>
        <translation>O que cada desvio causa</translation>
    </message>
    <message>
        <source>The tolerance, to either side</source>
        <translation>A tolerância, para os dois lados</translation>
    </message>
    <message>
        <source>Its part in how far colours land off their places</source>
        <translation>Sua parte em quanto as cores caem fora do lugar</translation>
    </message>
    <message>
        <source>How far off, by itself, half of what is painted is at most</source>
        <translation>Quanto, só por isso, metade do que é pintado fica fora do lugar, no máximo</translation>
    </message>
    <message>
        <source>How far off, by itself, 95 % of what is painted is at most</source>
        <translation>Quanto, só por isso, 95 % do que é pintado fica fora do lugar, no máximo</translation>
    </message>
    <message>
        <source>How far off, by itself, the worst place is</source>
        <translation>Quanto, só por isso, o pior lugar fica fora</translation>
    </message>
    <message>
        <source>How much less, or more, of the body is painted at the border</source>
        <translation>Quanto menos, ou mais, do corpo é pintado na borda</translation>
    </message>
    <message>
        <source>All together: 95 % of what is painted lands within %1 of its place, half of it within %2.</source>
        <translation>Tudo junto: 95 % do que é pintado cai a menos de %1 do lugar, metade a menos de %2.</translation>
    </message>
    <message>
        <source>Tolerance of the sheet</source>
        <translation>Tolerância da folha</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Números</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Tolerances</source>
        <translation>Tolerâncias</translation>
    </message>
    <message>
        <source>These are the figures of the project as it was before the last changes.</source>
        <translation>Estes são os números do projeto como estava antes das últimas mudanças.</translation>
    </message>
    <message>
        <source>%1 at %2 of the model, most by: %3</source>
        <translation>%1 em %2 do modelo, mais por: %3</translation>
    </message>
</context>
<context>
    <name>dipwright::Tour</name>
    <message>
        <source>Back</source>
        <translation>Voltar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Concluir</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Avançar</translation>
    </message>
</context>
<context>
    <name>dipwright::ViewController</name>
    <message>
        <source>Picture on the Film</source>
        <translation>Imagem no filme</translation>
    </message>
    <message>
        <source>Reading the picture</source>
        <translation>Lendo a imagem</translation>
    </message>
</context>
<context>
    <name>dipwright::WatchPage</name>
    <message>
        <source>Film watch: print this on the film</source>
        <translation>Medição do filme: imprima isto no filme</translation>
    </message>
    <message>
        <source>Card of the film watch: print this on stiff, waterproof card</source>
        <translation>Cartão da medição do filme: imprima isto em cartão rígido e impermeável</translation>
    </message>
    <message>
        <source>Ink side: this side up on the water, the words to be read from above.</source>
        <translation>Lado da tinta: este lado para cima na água, as palavras legíveis de cima.</translation>
    </message>
    <message>
        <source>Lay it flat on the water beside the film, this side up, in every photo.</source>
        <translation>Em cada foto, deitado na água ao lado do filme, com este lado para cima.</translation>
    </message>
    <message>
        <source>Both rulers must measure %1 mm; if not, say what they do measure when the photos are looked at.</source>
        <translation>Ambas as réguas devem medir %1 mm; se não, indique o que medem quando as fotos forem avaliadas.</translation>
    </message>
    <message>
        <source>Date %1   Lot %2   Water %3 °C</source>
        <translation>Data %1   Lote %2   Água %3 °C</translation>
    </message>
    <message>
        <source>Paper of %1 × %2 mm has no room for a chessboard with %3 corners; take a larger one</source>
        <translation>Papel de %1 × %2 mm não tem espaço para um tabuleiro com %3 cantos; use um maior</translation>
    </message>
</context>
<context>
    <name>dipwright::WedgePage</name>
    <message>
        <source>Paper of %1 × %2 mm has no room for the wedge; take a larger one</source>
        <translation>Papel de %1 × %2 mm não tem espaço para a cunha; use um maior</translation>
    </message>
    <message>
        <source>Ink wedge: print this on the film as a sheet is printed</source>
        <translation>Cunha de tinta: imprima no filme como se imprime uma folha</translation>
    </message>
    <message>
        <source>1. Zero the densitometer on unprinted film. Read every patch before the dip.</source>
        <translation>1. Zere o densitômetro em filme sem impressão. Leia cada amostra antes da imersão.</translation>
    </message>
    <message>
        <source>2. Stretch the film: on a body, or floating, by hand. Measure both rulers; %1 mm is no stretch.</source>
        <translation>2. Estire o filme: num corpo, ou flutuando, à mão. Meça as duas réguas; %1 mm é sem estiramento.</translation>
    </message>
    <message>
        <source>3. Read every patch again. Best at three or four stretches up to the job&apos;s.</source>
        <translation>3. Leia cada amostra de novo. Melhor com três ou quatro estiramentos até o do trabalho.</translation>
    </message>
    <message>
        <source>Date %1   Lot %2</source>
        <translation>Data %1   Lote %2</translation>
    </message>
</context>
<context>
    <name>dipwright::WedgeTable</name>
    <message>
        <source>The table of a wedge begins with the line %1 and has at most %2 lines</source>
        <translation>A tabela de uma cunha começa com a linha %1 e tem no máximo %2 linhas</translation>
    </message>
    <message>
        <source>Line %1 of the wedge is not an ink (cyan, magenta, yellow, black, white or grey) and five numbers, joined by commas</source>
        <translation>A linha %1 da cunha não é uma tinta (cyan, magenta, yellow, black, white ou grey) e cinco números, ligados por vírgulas</translation>
    </message>
</context>
<context>
    <name>dipwright::WeightFields</name>
    <message>
        <source>Counts</source>
        <translation>Conta</translation>
    </message>
    <message>
        <source>Must be kept</source>
        <translation>A manter</translation>
    </message>
    <message>
        <source>Quality in zone %1</source>
        <translation>Qualidade na zona %1</translation>
    </message>
    <message>
        <source>How much more the quality counts where the body is marked as this zone, under Tolerances.</source>
        <translation>Quanto mais a qualidade conta onde o corpo está marcado como esta zona, em Tolerâncias.</translation>
    </message>
    <message>
        <source>Weight of %1</source>
        <translation>Peso de %1</translation>
    </message>
    <message>
        <source>How much it counts against the others; 0: not at all.</source>
        <translation>Quanto conta em relação às outras; 0: nada.</translation>
    </message>
    <message>
        <source>Limit of %1</source>
        <translation>Limite de %1</translation>
    </message>
    <message>
        <source>Poses that miss it come after all that keep it.</source>
        <translation>Poses que não o cumprem vêm depois de todas que o cumprem.</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowActions</name>
    <message>
        <source>New &amp;Window</source>
        <translation>Nova &amp;janela</translation>
    </message>
    <message>
        <source>Open another window</source>
        <translation>Abre outra janela</translation>
    </message>
    <message>
        <source>&amp;New Project…</source>
        <translation>&amp;Novo projeto…</translation>
    </message>
    <message>
        <source>Make a project of a textured model</source>
        <translation>Cria um projeto de um modelo texturizado</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Abre um projeto</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salvar</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Salva o projeto</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Salvar &amp;como…</translation>
    </message>
    <message>
        <source>Save the project as another file</source>
        <translation>Salva o projeto em outro arquivo</translation>
    </message>
    <message>
        <source>&amp;Export Results…</source>
        <translation>&amp;Exportar resultados…</translation>
    </message>
    <message>
        <source>Write sheets, stretch maps, proof, films and report to a folder</source>
        <translation>Grava folhas, mapas de estiramento, prova, filmes e relatório em uma pasta</translation>
    </message>
    <message>
        <source>Sheet as P&amp;DF…</source>
        <translation>Folha em P&amp;DF…</translation>
    </message>
    <message>
        <source>Save this immersion&apos;s sheet as PDF at true size</source>
        <translation>Salva a folha desta imersão em PDF em tamanho real</translation>
    </message>
    <message>
        <source>Sheet as P&amp;NG…</source>
        <translation>Folha em P&amp;NG…</translation>
    </message>
    <message>
        <source>Save this immersion&apos;s film image as PNG</source>
        <translation>Salva a imagem do filme desta imersão em PNG</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>&amp;Imprimir…</translation>
    </message>
    <message>
        <source>Print sheets at true size</source>
        <translation>Imprime as folhas em tamanho real</translation>
    </message>
    <message>
        <source>Calibrate P&amp;rinter…</source>
        <translation>Calibrar imp&amp;ressora…</translation>
    </message>
    <message>
        <source>Print a page of rulers and put the printer&apos;s scale into its profile</source>
        <translation>Imprimir uma página de réguas e guardar a escala da impressora no perfil dela</translation>
    </message>
    <message>
        <source>Pro&amp;files…</source>
        <translation>Per&amp;fis…</translation>
    </message>
    <message>
        <source>What is known of printers, films and tanks</source>
        <translation>O que se sabe de impressoras, filmes e tanques</translation>
    </message>
    <message>
        <source>&amp;Close Window</source>
        <translation>&amp;Fechar janela</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Fecha esta janela</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Sair</translation>
    </message>
    <message>
        <source>Close all windows</source>
        <translation>Fecha todas as janelas</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Desfazer</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Desfaz a última mudança</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Refazer</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>Faz a mudança de novo</translation>
    </message>
    <message>
        <source>Add &amp;Second Immersion</source>
        <translation>Adicionar &amp;segunda imersão</translation>
    </message>
    <message>
        <source>Dip the body a second time, from another side</source>
        <translation>Mergulha o corpo uma segunda vez, de outro lado</translation>
    </message>
    <message>
        <source>Remove &amp;Immersion</source>
        <translation>Remover &amp;imersão</translation>
    </message>
    <message>
        <source>Remove the immersion shown</source>
        <translation>Remove a imersão mostrada</translation>
    </message>
    <message>
        <source>Re&amp;load Model</source>
        <translation>&amp;Recarregar modelo</translation>
    </message>
    <message>
        <source>Read the model&apos;s file again and keep all settings</source>
        <translation>Lê de novo o arquivo do modelo e mantém as configurações</translation>
    </message>
    <message>
        <source>Replace &amp;Model…</source>
        <translation>Trocar &amp;modelo…</translation>
    </message>
    <message>
        <source>Take another model</source>
        <translation>Usa outro modelo</translation>
    </message>
    <message>
        <source>Replace &amp;Texture…</source>
        <translation>Trocar &amp;textura…</translation>
    </message>
    <message>
        <source>Put another picture on the model</source>
        <translation>Põe outra imagem no modelo</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>&amp;Preferências…</translation>
    </message>
    <message>
        <source>Units, language, look, shortcuts and solvers</source>
        <translation>Unidades, idioma, aparência, atalhos e solucionadores</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>E&amp;xecutar</translation>
    </message>
    <message>
        <source>Simulate the dip and make the sheets</source>
        <translation>Simula a imersão e faz as folhas</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>Stop what is running</source>
        <translation>Para o que está em execução</translation>
    </message>
    <message>
        <source>Run &amp;Live</source>
        <translation>Executar ao &amp;vivo</translation>
    </message>
    <message>
        <source>Once there is a result, run again after each change</source>
        <translation>Havendo um resultado, executa de novo após cada mudança</translation>
    </message>
    <message>
        <source>C&amp;heck Certainty…</source>
        <translation>Verificar c&amp;onfiabilidade…</translation>
    </message>
    <message>
        <source>Compute the sheets more finely and see how far they move, and where</source>
        <translation>Calcular as folhas com mais finura e ver quanto se deslocam, e onde</translation>
    </message>
    <message>
        <source>&amp;Play or Pause</source>
        <translation>&amp;Reproduzir ou pausar</translation>
    </message>
    <message>
        <source>Play the dip</source>
        <translation>Reproduz a imersão</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Enquadrar</translation>
    </message>
    <message>
        <source>Show body and film whole</source>
        <translation>Mostra corpo e filme inteiros</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>&amp;Oblíqua</translation>
    </message>
    <message>
        <source>Look from above at an angle</source>
        <translation>Olha de cima em ângulo</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>&amp;Frente</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>Olha de frente</translation>
    </message>
    <message>
        <source>Ri&amp;ght</source>
        <translation>&amp;Direita</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>Olha da direita</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Em &amp;cima</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>Olha de cima</translation>
    </message>
    <message>
        <source>Bac&amp;k</source>
        <translation>&amp;Trás</translation>
    </message>
    <message>
        <source>Look from behind</source>
        <translation>Olha de trás</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Esquerda</translation>
    </message>
    <message>
        <source>Look from the left</source>
        <translation>Olha da esquerda</translation>
    </message>
    <message>
        <source>&amp;Bottom</source>
        <translation>Em&amp;baixo</translation>
    </message>
    <message>
        <source>Look from below</source>
        <translation>Olha de baixo</translation>
    </message>
    <message>
        <source>&amp;Standard Layout</source>
        <translation>Disposição &amp;padrão</translation>
    </message>
    <message>
        <source>Put all panels back where they were at first</source>
        <translation>Põe todos os painéis de volta no lugar</translation>
    </message>
    <message>
        <source>&amp;Save Layout…</source>
        <translation>&amp;Salvar disposição…</translation>
    </message>
    <message>
        <source>Keep where the panels are under a name</source>
        <translation>Guardar a disposição dos painéis com um nome</translation>
    </message>
    <message>
        <source>&amp;Parallel Projection</source>
        <translation>Projeção &amp;paralela</translation>
    </message>
    <message>
        <source>Show equal lengths equally long, near or far</source>
        <translation>Mostra comprimentos iguais com igual tamanho, perto ou longe</translation>
    </message>
    <message>
        <source>&amp;Water and Tank</source>
        <translation>Á&amp;gua e tanque</translation>
    </message>
    <message>
        <source>Show the water and the edges of the tank</source>
        <translation>Mostra a água e as bordas do tanque</translation>
    </message>
    <message>
        <source>Bo&amp;dy</source>
        <translation>&amp;Corpo</translation>
    </message>
    <message>
        <source>Show the body</source>
        <translation>Mostra o corpo</translation>
    </message>
    <message>
        <source>&amp;Coverage on the Body</source>
        <translation>Co&amp;bertura no corpo</translation>
    </message>
    <message>
        <source>Film on the Body &amp;Only</source>
        <translation>&amp;Só o filme no corpo</translation>
    </message>
    <message>
        <source>At the end of the dip, hide the film that paints nothing</source>
        <translation>No fim da imersão, esconde o filme que não pinta nada</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Medir</translation>
    </message>
    <message>
        <source>Click two places on the body to measure the distance between them</source>
        <translation>Clique em dois lugares do corpo para medir a distância</translation>
    </message>
    <message>
        <source>What the film wears in the view</source>
        <translation>O que o filme veste na vista</translation>
    </message>
    <message>
        <source>&amp;Lines every 10 mm</source>
        <translation>&amp;Linhas a cada 10 mm</translation>
    </message>
    <message>
        <source>The &amp;Sheet&apos;s Image</source>
        <translation>A imagem da &amp;folha</translation>
    </message>
    <message>
        <source>S&amp;tretch</source>
        <translation>&amp;Estiramento</translation>
    </message>
    <message>
        <source>&amp;Chessboard of 17 mm</source>
        <translation>&amp;Xadrez de 17 mm</translation>
    </message>
    <message>
        <source>A &amp;Picture…</source>
        <translation>Uma &amp;imagem…</translation>
    </message>
    <message>
        <source>Quick &amp;Tour</source>
        <translation>&amp;Visita rápida</translation>
    </message>
    <message>
        <source>What is where, in six steps</source>
        <translation>O que está onde, em seis passos</translation>
    </message>
    <message>
        <source>User &amp;Guide</source>
        <translation>&amp;Guia do usuário</translation>
    </message>
    <message>
        <source>&amp;What Is This?</source>
        <translation>O &amp;que é isto?</translation>
    </message>
    <message>
        <source>Click something afterwards to be told what it is for</source>
        <translation>Clique depois em algo para saber para que serve</translation>
    </message>
    <message>
        <source>&amp;About Dipwright</source>
        <translation>&amp;Sobre o Dipwright</translation>
    </message>
    <message>
        <source>&amp;Undo “%1”</source>
        <translation>&amp;Desfazer “%1”</translation>
    </message>
    <message>
        <source>&amp;Redo “%1”</source>
        <translation>&amp;Refazer “%1”</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Crad&amp;les…</source>
        <translation>&amp;Berços…</translation>
    </message>
    <message>
        <source>Make what holds the body in each dip, as STL and 3MF to print in plastic</source>
        <translation>Fazer o que segura o corpo em cada mergulho, em STL e 3MF para imprimir em plástico</translation>
    </message>
    <message>
        <source>Show what the dips paint of the body</source>
        <translation>Mostra o que as imersões pintam do corpo</translation>
    </message>
    <message>
        <source>&amp;Print on the Body</source>
        <translation>Im&amp;pressão no corpo</translation>
    </message>
    <message>
        <source>Show the body as it comes out of all dips, from every side</source>
        <translation>Mostra o corpo como sai de todas as imersões, de todos os lados</translation>
    </message>
    <message>
        <source>S&amp;wap Immersions</source>
        <translation>Tro&amp;car imersões</translation>
    </message>
    <message>
        <source>Make the second dip the first one</source>
        <translation>Torna a segunda imersão a primeira</translation>
    </message>
    <message>
        <source>&amp;Who Paints What</source>
        <translation>&amp;Quem pinta o quê</translation>
    </message>
    <message>
        <source>&amp;Tolerances…</source>
        <translation>&amp;Tolerâncias…</translation>
    </message>
    <message>
        <source>See how far colours land off their places for what is off, and which zones keep their limits</source>
        <translation>Mostra quanto as cores caem fora do lugar pelos desvios e que zonas respeitam seus limites</translation>
    </message>
    <message>
        <source>&amp;Zones on the Body</source>
        <translation>&amp;Zonas no corpo</translation>
    </message>
    <message>
        <source>Show the zones of the body and, once tolerances are told, where they keep their limits</source>
        <translation>Mostra as zonas do corpo e, calculadas as tolerâncias, onde respeitam seus limites</translation>
    </message>
    <message>
        <source>&amp;Find Poses…</source>
        <translation>&amp;Procurar poses…</translation>
    </message>
    <message>
        <source>Search how the body is best turned and moved, for one dip or two</source>
        <translation>Procura como o corpo é mais bem girado e movido, para uma ou duas imersões</translation>
    </message>
    <message>
        <source>Print &amp;History…</source>
        <translation>&amp;Histórico de impressão…</translation>
    </message>
    <message>
        <source>See what was printed when, on what, and from which project</source>
        <translation>Ver o que foi impresso quando, em quê e de qual projeto</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>&amp;Corte</translation>
    </message>
    <message>
        <source>Cut body and film open by a plane that a slider or its frame moves</source>
        <translation>Abrir corpo e filme por um plano que um controle ou sua moldura move</translation>
    </message>
    <message>
        <source>S&amp;ee-Through Film</source>
        <translation>Film&amp;e translúcido</translation>
    </message>
    <message>
        <source>See the body through the film</source>
        <translation>Ver o corpo através do filme</translation>
    </message>
    <message>
        <source>Snapsho&amp;ts…</source>
        <translation>Instan&amp;tâneos…</translation>
    </message>
    <message>
        <source>Keep the project&apos;s settings under a name, compare them, and go back</source>
        <translation>Guardar as definições do projeto sob um nome, compará-las e voltar</translation>
    </message>
    <message>
        <source>&amp;Job Queue…</source>
        <translation>&amp;Fila de trabalhos…</translation>
    </message>
    <message>
        <source>Run several projects one after the other, and go on working</source>
        <translation>Executar vários projetos um depois do outro e continuar a trabalhar</translation>
    </message>
    <message>
        <source>Turn the body by 15°</source>
        <translation>Girar o corpo 15°</translation>
    </message>
    <message>
        <source>Move the body over the film</source>
        <translation>Mover o corpo sobre o filme</translation>
    </message>
    <message>
        <source>Turn about &amp;X by 15°</source>
        <translation>Girar 15° em torno de &amp;X</translation>
    </message>
    <message>
        <source>Turn about X by −15°</source>
        <translation>Girar −15° em torno de X</translation>
    </message>
    <message>
        <source>Turn about &amp;Y by 15°</source>
        <translation>Girar 15° em torno de &amp;Y</translation>
    </message>
    <message>
        <source>Turn about Y by −15°</source>
        <translation>Girar −15° em torno de Y</translation>
    </message>
    <message>
        <source>Turn about &amp;Z by 15°</source>
        <translation>Girar 15° em torno de &amp;Z</translation>
    </message>
    <message>
        <source>Turn about Z by −15°</source>
        <translation>Girar −15° em torno de Z</translation>
    </message>
    <message>
        <source>Move to the &amp;Right by 5 mm</source>
        <translation>Mover 5 mm para a &amp;direita</translation>
    </message>
    <message>
        <source>Move to the &amp;Left by 5 mm</source>
        <translation>Mover 5 mm para a &amp;esquerda</translation>
    </message>
    <message>
        <source>Move &amp;Up the Sheet by 5 mm</source>
        <translation>Mover 5 mm folha a&amp;cima</translation>
    </message>
    <message>
        <source>Move &amp;Down the Sheet by 5 mm</source>
        <translation>Mover 5 mm folha a&amp;baixo</translation>
    </message>
    <message>
        <source>Move to the Film&apos;s &amp;Middle</source>
        <translation>Mover para o &amp;meio do filme</translation>
    </message>
    <message>
        <source>How everything works, beginning with what has the focus</source>
        <translation>Como tudo funciona, a começar pelo que tem o foco</translation>
    </message>
    <message>
        <source>Several Jobs on One &amp;Film…</source>
        <translation>Vários trabalhos em um &amp;filme…</translation>
    </message>
    <message>
        <source>Lay the sheets of several projects, and copies, side by side on a film or roll</source>
        <translation>Dispor as folhas de vários projetos, e cópias, lado a lado em um filme ou rolo</translation>
    </message>
    <message>
        <source>&amp;Artwork</source>
        <translation>A&amp;rte</translation>
    </message>
    <message>
        <source>Lay pictures, text and patterns on the body</source>
        <translation>Pôr imagens, texto e padrões sobre o corpo</translation>
    </message>
    <message>
        <source>Rings and Arr&amp;ows</source>
        <translation>Anéis e &amp;setas</translation>
    </message>
    <message>
        <source>Show the rings that turn the body and the arrows that move it</source>
        <translation>Mostrar os anéis que giram o corpo e as setas que o movem</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowLayout</name>
    <message>
        <source>3D view of the dip</source>
        <translation>Vista 3D da imersão</translation>
    </message>
    <message>
        <source>The body above the film. Drag to turn the view, drag with the right button to shift it, turn the wheel to zoom. Drag a ring to turn the body.</source>
        <translation>O corpo acima do filme. Arraste para girar a vista, com o botão direito para deslocá-la, use a roda para o zoom. Arraste um anel para girar o corpo.</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projeto</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Resultados</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Save Layout</source>
        <translation>Salvar disposição</translation>
    </message>
    <message>
        <source>Name of the layout</source>
        <translation>Nome da disposição</translation>
    </message>
    <message>
        <source>None saved yet</source>
        <translation>Nenhuma salva ainda</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Remover</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowMenus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Arquivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Dip</source>
        <translation>&amp;Imersão</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>&amp;Janela</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Aj&amp;uda</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Abrir &amp;recente</translation>
    </message>
    <message>
        <source>Film &amp;Wears</source>
        <translation>Filme &amp;veste</translation>
    </message>
    <message>
        <source>&amp;Layouts</source>
        <translation>&amp;Disposições</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Principal</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>What the film wears in the view</source>
        <translation>O que o filme veste na vista</translation>
    </message>
    <message>
        <source>Turn &amp;Body</source>
        <translation>Girar &amp;corpo</translation>
    </message>
    <message>
        <source>Mo&amp;ve Body</source>
        <translation>&amp;Mover corpo</translation>
    </message>
    <message>
        <source>Film appearance</source>
        <translation>Aparência do filme</translation>
    </message>
</context>
<context>
    <name>dipwright::WindowMessages</name>
    <message>
        <source>Read Them</source>
        <translation>Ler</translation>
    </message>
    <message>
        <source>Read them only if they belong to the model. A stranger&apos;s model or project may name private files, so that they travel on inside the project.</source>
        <translation>Leia-os apenas se pertencerem ao modelo. Um modelo ou projeto de um desconhecido pode citar arquivos privados, para que sigam viagem dentro do projeto.</translation>
    </message>
</context>
<context>
    <name>dipwright::Workbench</name>
    <message>
        <source>Restore Project</source>
        <translation>Restaurar projeto</translation>
    </message>
    <message>
        <source>Dipwright was not closed properly. “%1” has changes that were not saved, from %2.</source>
        <translation>O Dipwright não foi fechado corretamente. “%1” tem mudanças não salvas, de %2.</translation>
    </message>
    <message>
        <source>It was never saved as a file.</source>
        <translation>Nunca foi salvo como arquivo.</translation>
    </message>
    <message>
        <source>Its file %1 is as it was last saved.</source>
        <translation>Seu arquivo %1 está como foi salvo pela última vez.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurar</translation>
    </message>
    <message>
        <source>Discard Changes</source>
        <translation>Descartar mudanças</translation>
    </message>
    <message>
        <source>Decide Later</source>
        <translation>Decidir depois</translation>
    </message>
</context>
<context>
    <name>dipwright::ZoneFields</name>
    <message>
        <source>Marks zone %1</source>
        <translation>Marca a zona %1</translation>
    </message>
    <message>
        <source>What a click or a drag on the body in the view marks. Zone A is to be painted most exactly; what is not marked is zone C.</source>
        <translation>O que um clique ou um arrasto no corpo na vista marca. A zona A deve ser pintada com mais exatidão; o que não é marcado é zona C.</translation>
    </message>
    <message>
        <source>How far</source>
        <translation>Até onde</translation>
    </message>
    <message>
        <source>A spot</source>
        <translation>Uma mancha</translation>
    </message>
    <message>
        <source>The whole face</source>
        <translation>A face inteira</translation>
    </message>
    <message>
        <source>All of the material</source>
        <translation>Tudo desse material</translation>
    </message>
    <message>
        <source>How far round the click the mark reaches: a radius along the surface, the face up to its edges, or all that has the same material in the model.</source>
        <translation>Até onde em torno do clique a marca vai: um raio ao longo da superfície, a face até suas arestas ou tudo o que tem o mesmo material no modelo.</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Computational hydrographic printing.</source>
        <translation>Impressão hidrográfica computacional.</translation>
    </message>
    <message>
        <source>Projects to open.</source>
        <translation>Projetos a abrir.</translation>
    </message>
</context>
</TS>
